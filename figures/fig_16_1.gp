# Figure 16.1 - estimated beside true errors of forces and displacements, and of half-widths; grey is half to twice.
# In: fig_16_1.csv, fig_16_1_width.csv   Out: fig_16_1.svg
width = 860; height = 540
load 'style.gp'
eval LOGLOG
set format xy '%g'
set xtics ('10^{-4}' 1e-4, '0.01' 1e-2, '1' 1)
set ytics ('10^{-4}' 1e-4, '0.001' 1e-3, '0.01' 1e-2, '0.1' 0.1, '1' 1, '10' 10)
set xrange [1e-5:10]
set yrange [1e-5:10]
set samples 2
set multiplot
set bmargin at screen 0.36
set tmargin at screen 0.88
set xlabel 'true error [%]'
set key at screen 0.03,0.01 left bottom maxrows 2 samplen 1 width -3 noopaque
of(name) = strcol('element') eq name ? column('estimate') : NaN
set lmargin at screen 0.115
set rmargin at screen 0.49
set title 'forces and displacements'
set ylabel 'estimate [%]' offset 1,0
set label 1 'pin, q8' at 1e-4,0.06 center textcolor rgb RED
file = data.'/fig_16_1.csv'
plot '+' using 1:($1/2):($1*2) with filledcurves lc rgb LIGHT notitle, x with lines ls 8 lw 0.8 notitle, \
     file using 'error':(of('q4')) with points pt 7 ps 0.7 lc rgb BLUE title 'q4', \
     '' using 'error':(of('q4_bbar')) with points pt 9 ps 0.9 lc rgb GREEN title 'q4 bbar', \
     '' using 'error':(of('q4_incompatible')) with points pt 12 ps 0.9 lw 1.5 lc rgb BLACK title 'q4 incompatible', \
     '' using 'error':(of('q8')) with points pt 4 ps 0.8 lw 1.5 lc rgb RED title 'q8', \
     '' using (column('sign') > 0 ? column('error') : NaN):'estimate' with points pt 2 ps 1.6 lw 1.5 lc rgb BLACK title 'wrong sign'
set lmargin at screen 0.60
set rmargin at screen 0.975
set title 'half-width on 25 meshes'
unset ylabel
unset label 1
file = data.'/fig_16_1_width.csv'
plot '+' using 1:($1/2):($1*2) with filledcurves lc rgb LIGHT notitle, x with lines ls 8 lw 0.8 notitle, \
     file using 'error':(of('q4')) with points pt 7 ps 0.7 lc rgb BLUE notitle, \
     '' using 'error':(of('q4_bbar')) with points pt 9 ps 0.9 lc rgb GREEN notitle, \
     '' using 'error':(of('q4_incompatible')) with points pt 12 ps 0.9 lw 1.5 lc rgb BLACK notitle, \
     '' using 'error':(of('q8')) with points pt 4 ps 0.8 lw 1.5 lc rgb RED notitle
unset multiplot
