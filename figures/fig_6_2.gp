# Figure 6.2 - total contact force against the load.   In: fig_6_2.csv   Out: fig_6_2.svg
load 'style.gp'
set xlabel 'load {/:Italic q} [kN/cm²]'
set ylabel 'total contact force [kN]'
set xrange [0:4]
set yrange [0:100]
set key top left
set arrow 1 from 0.28,0 to 0.28,62 nohead ls 8
set arrow 2 from 2.52,0 to 2.52,62 nohead ls 8
set label 1 'nothing' at 0.03,66 left font ',11'
set label 2 'the tip touches' at 1.4,66 center font ',11'
set label 3 'a line touches' at 3.2,30 center font ',11'
plot data.'/fig_6_2.csv' using 'q':'euler_bernoulli' with lines ls 7 title 'Euler-Bernoulli beam', \
     '' using 'q':'timoshenko' with lines ls 4 title 'Timoshenko beam', \
     '' using 'q':'force' with points ls 1 title 'q4\_incompatible, 100 × 10'
