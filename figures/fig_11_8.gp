# Figure 11.8 - stress on the axis.   In: fig_11_8.csv, fig_11_8_disc.csv, fig_11_8_plate.csv   Out: fig_11_8.svg
height = 440
load 'style.gp'
set xlabel 'depth below the contact [mm]'
set ylabel 'stress [MPa]'
set xrange [0:4]
set yrange [-40:10]
set ytics 10
set key bottom right
plot data.'/fig_11_8.csv' using 'depth':'shear' with lines ls 7 dt 1 title '(σ_x − σ_y)/2, half-plane', \
     '' using 'depth':'xx' with lines ls 7 dt (12,4) title 'σ_x, half-plane', \
     '' using 'depth':'yy' with lines ls 7 dt (3,3) title 'σ_y, half-plane', \
     data.'/fig_11_8_disc.csv' using 'depth':'shear' with points ls 1 title 'disc', \
     '' using 'depth':'xx' with points ls 1 notitle, '' using 'depth':'yy' with points ls 1 notitle, \
     data.'/fig_11_8_plate.csv' using 'depth':'shear' with points ls 5 title 'plate', \
     '' using 'depth':'xx' with points ls 5 notitle, '' using 'depth':'yy' with points ls 5 notitle
