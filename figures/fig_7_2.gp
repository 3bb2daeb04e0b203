# Figure 7.2 - contact pressure around the hole.   In: fig_7_2.csv, fig_7_2_paper.csv   Out: fig_7_2.svg
width = 480; height = 360
load 'style.gp'
set lmargin 8
set xlabel 'angle from the pole {/:Italic θ} [deg]'
set ylabel 'contact pressure {/:Italic q}_N [kN/cm²]'
set xrange [0:90]
set yrange [0:80]
set xtics 15
set key bottom left
plot data.'/fig_7_2.csv' using 'theta':'t' with lines ls 1 title '(T) pulled, 144 × 72', \
     data.'/fig_7_2_paper.csv' using 'theta':'t' with points ls 1 ps 0.9 title '(T) 15 × 15', \
     data.'/fig_7_2.csv' using 'theta':'c' with lines ls 2 title '(C) pressed, 144 × 72', \
     data.'/fig_7_2_paper.csv' using 'theta':'c' with points ls 2 ps 0.9 title '(C) 15 × 15'
