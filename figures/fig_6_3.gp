# Figure 6.3 - contact pressure under the cantilever.   In: fig_6_3.csv   Out: fig_6_3.svg
width = 480; height = 420
load 'style.gp'
set lmargin 8
set xlabel 'position along the beam {/:Italic x} [cm]'
set ylabel 'contact pressure {/:Italic q}_N [kN/cm²]'
set xrange [40:50.2]
set yrange [0:34]
set key noopaque
set arrow 1 from 45.7346,3.6 to 45.7346,12.9 head filled size 0.12,20 ls 7
set label 1 'point force 54.9 kN' at 45.85,12.6 left
set arrow 2 from 50,3.6 to 50,6.3 head filled size 0.12,20 ls 4
set label 2 '5.2 kN' at 49.9,5.2 right
plot data.'/fig_6_3.csv' using 'x':'q4' with linespoints ls 2 ps 0.5 title 'q4, 200 × 20', \
     '' using 'x':'q8' with linespoints ls 3 ps 0.6 title 'q8, 100 × 10', \
     '' using 'x':'q4_incompatible' with lines ls 1 title 'q4\_incompatible, 200 × 20', \
     '' using (column('x')):(column('timoshenko') > 0 ? column('timoshenko') : NaN) with lines ls 4 title 'Timoshenko beam', \
     '' using (column('x')):(column('euler_bernoulli') > 0 ? column('euler_bernoulli') : NaN) with lines ls 7 title 'Euler-Bernoulli beam'
