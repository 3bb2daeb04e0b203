# Figure 22.1 - what the linear gap lacks after a way along a disc.   In: fig_22_1.csv   Out: fig_22_1.svg
load 'style.gp'
eval LOGLOG
file = data.'/fig_22_1.csv'
set xlabel 'way {/:Italic s} along the tangent [mm]'
set ylabel 'error of the linear gap [mm]' offset 1,0
set xrange [8e-3:4]
set yrange [2e-6:2]
set key top left Left reverse
plot file using 'way':'expected' with lines ls 7 title '{/:Italic s}^2/2{/:Italic R}', \
     '' using 'way':'error' with points ls 1 title 'disc of {/:Italic R} = 10 mm'
