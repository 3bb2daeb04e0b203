# Figure 22.6 - the roller by four answers to strain: approach against the mesh, and the pressure on the finest.
# In: fig_22_6.csv, fig_22_6_pressure.csv   Out: fig_22_6.svg
width = 640; height = 720
load 'style.gp'
meshes = data.'/fig_22_6.csv'
pressure = data.'/fig_22_6_pressure.csv'
of(key, name) = strcol('answer') eq key ? column(name) : NaN
set multiplot
set lmargin at screen 0.14; set rmargin at screen 0.96
set tmargin at screen 0.985; set bmargin at screen 0.59
set xlabel '(16 / cells of the core)^2'
set ylabel 'under the roller [mm]' offset 1,0
set xrange [0:1.05]
set yrange [-1.315:-1.255]
set ytics 0.01
set format y '%.2f'
unset key
set arrow 1 from 0,-1.3069 to 1.05,-1.3069 nohead ls 7
set label 1 'published' at 1.04,-1.3093 right
inverse(cells) = (16/column(cells))**2
plot meshes using (inverse('cells')):(of('linear', 'under')) with linespoints ls 4, \
     '' using (inverse('cells')):(of('moving', 'under')) with linespoints ls 3, \
     '' using (inverse('cells')):(of('st_venant', 'under')) with linespoints ls 2, \
     '' using (inverse('cells')):(of('neo_hooke', 'under')) with linespoints ls 1
unset arrow 1; unset label 1
set tmargin at screen 0.45; set bmargin at screen 0.09
set xlabel 'from the middle of the contact [mm]'
set ylabel 'pressure [MPa]'
set xrange [0:8]
set yrange [0:4000]
set ytics 1000
set format y '%.0f'
set key bottom left Left reverse noopaque
plot pressure using 'x':(of('linear', 'pressure')) with lines ls 4 title 'small strain, linear gap', \
     '' using 'x':(of('moving', 'pressure')) with lines ls 3 title 'small strain, bodies move', \
     '' using 'x':(of('st_venant', 'pressure')) with lines ls 2 title 'St Venant-Kirchhoff', \
     '' using 'x':(of('neo_hooke', 'pressure')) with lines ls 1 title 'neo-Hooke'
unset multiplot
