# Figure 14.2 - gap and contact pressure against the load.   In: fig_14_2.csv, fig_14_2_mesh.csv   Out: fig_14_2.svg
height = 560
load 'style.gp'
set multiplot layout 2,1
set xrange [0:185]
set ylabel 'gap [cm]'
set yrange [0:0.18]
set ytics 0.05
set arrow 1 from 72.398,0 to 72.398,0.18 nohead ls 8
set label 1 'the gap is closed' at 76,0.06
plot data.'/fig_14_2.csv' using 'p':'gap' with lines ls 7 title 'closed form', \
     data.'/fig_14_2_mesh.csv' using 'p':'gap' with points ls 1 title '120 nodes'
unset label
set arrow 1 from 72.398,0 to 72.398,50 nohead ls 8
set key top left
set xlabel 'pressure inside {/:Italic p} [MPa]'
set ylabel 'contact pressure [MPa]'
set yrange [0:50]
set ytics 10
plot data.'/fig_14_2.csv' using 'p':'pressure' with lines ls 7 title 'closed form', \
     data.'/fig_14_2_mesh.csv' using 'p':'pressure' with points ls 1 title '120 nodes'
unset multiplot
