# Figure 17.2 - the error of x against the condition number, with and without the refined end.
# In: fig_17_2.csv   Out: fig_17_2.svg
width = 640; height = 540
load 'style.gp'
set logscale xy
set format x '10^{%T}'
set ytics ('10^{-2}' 1e-2, '10^{-6}' 1e-6, '10^{-10}' 1e-10, '10^{-14}' 1e-14, '0' 1e-17)
set xrange [10:1e14]
set yrange [2e-18:1e-2]
set xlabel 'condition number of K'
set ylabel 'largest error of x, which is 1'
set key at screen 0.5,0.01 bottom center maxrows 4 noopaque
set bmargin at screen 0.42
set tmargin at screen 0.96
set arrow 1 from 10, 1e-12 to 1e14, 1e-12 nohead ls 8
set label 1 'what a certificate may say' at 8e13, 1e-12 right offset 0,-0.8 textcolor rgb GREY
least(x) = x > 1e-17 ? x : 1e-17
plot data.'/fig_17_2.csv' using 'condition':(least(column('plain'))) with linespoints ls 2 title 'in double precision', \
     '' using 'condition':(least(column('refined'))) with linespoints ls 1 title 'with the refined end', \
     2.2e-16*x with lines ls 8 title 'condition times rounding', \
     '' using 'condition':(least(column('refined_certificate'))) with points ls 3 title 'certificate of the refined end'
