# Figure 6.2 - total contact force against the load.   In: fig_6_2.csv, fig_6_2_body.csv   Out: fig_6_2.svg
width = 480; height = 580
load 'style.gp'
set lmargin 9
set multiplot layout 2,1
set xrange [0:4]
set yrange [0:100]
set ylabel 'total contact force [kN]' offset 1,0
set key top left
set arrow 1 from 0.28,0 to 0.28,55 nohead ls 8
set arrow 2 from 2.52,0 to 2.52,55 nohead ls 8
set label 1 'nothing' at 0.36,60 center
set label 2 'the tip touches' at 1.7,60 center
set label 3 'a line touches' at 3.25,25 center
plot data.'/fig_6_2.csv' using 'q':'euler_bernoulli' with lines ls 7 title 'Euler-Bernoulli beam', \
     '' using 'q':'timoshenko' with lines ls 4 title 'Timoshenko beam', \
     data.'/fig_6_2_body.csv' using 'q':'force' with points ls 1 title 'q4\_incompatible, 100 × 10'
unset arrow
unset label
set xlabel 'load {/:Italic q} [kN/cm²]'
set ylabel 'above Euler-Bernoulli [kN]' offset 1,0
set yrange [-0.2:2]
plot data.'/fig_6_2.csv' using (column('q')):(column('timoshenko')-column('euler_bernoulli')) with lines ls 4 title 'Timoshenko beam', \
     0 with lines ls 7 notitle, \
     data.'/fig_6_2_body.csv' using (column('q')):(column('force')-column('euler_bernoulli')) with points ls 1 title 'q4\_incompatible, 100 × 10'
unset multiplot
