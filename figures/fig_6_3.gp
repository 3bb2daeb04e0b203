# Figure 6.3 - contact pressure under the cantilever.   In: fig_6_3.csv   Out: fig_6_3.svg
width = 480; height = 400
load 'style.gp'
set lmargin 8
set xlabel 'position along the beam {/:Italic x} [cm]'
set ylabel 'contact pressure {/:Italic q}_N [kN/cm²]'
set xrange [40:50.2]
set yrange [0:24]
set key at 50.2,23.6 top right width -1
# point forces have no pressure: their arrows are to scale with each other, a third of a step of the axis for 1 kN
set arrow 1 from 45.7346,3.6 to 45.7346,3.6 + 54.9/3 head filled size 0.14,20 ls 7
set label 1 'point force 54.9 kN' at 45.85,16 left
set arrow 2 from 50,3.6 to 50,3.6 + 5.2/3 head filled size 0.14,20 ls 4 dt 1
set label 2 '5.2 kN' at 49.85,5.6 right
set label 3 'Timoshenko' at 42.6,20.6 right
set label 4 'Euler-Bernoulli' at 47,2.4 left
set label 5 'body' at 42.2,8.5 right
plot data.'/fig_6_3.csv' using 'x':'q4' with linespoints ls 2 ps 0.5 title 'q4', \
     '' using 'x':'q8' with linespoints ls 3 ps 0.6 title 'q8', \
     '' using 'x':'q4_incompatible' with lines ls 1 title 'q4\_incompatible', \
     '' using (column('x')):(column('timoshenko') > 0 ? column('timoshenko') : NaN) with lines ls 4 notitle, \
     '' using (column('x')):(column('euler_bernoulli') > 0 ? column('euler_bernoulli') : NaN) with lines ls 7 notitle
