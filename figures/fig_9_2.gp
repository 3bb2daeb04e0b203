# Figure 9.2 - residuals of Newton's method, condensed and uncondensed.   In: fig_9_2.csv   Out: fig_9_2.svg
height = 520
load 'style.gp'
eval LOGY
file = data.'/fig_9_2.csv'
set xrange [0:10.3]
set xtics 1
set xlabel 'step'
set ylabel 'residual, over that at the start'
set yrange [1e-18:10]
set ytics 1e-18, 1e3
set tmargin 6.5
set lmargin 10
set key at graph 1,1.03 bottom right
plot file using 'step':'residual' every :::0::0 with linespoints ls 1 title 'condensed', \
     file using 'step':'residual' every :::1::1 with linespoints ls 2 title 'uncondensed, scaled', \
     file using 'step':'residual' every :::2::2 with linespoints ls 3 title 'uncondensed, unscaled, in mm and N', \
     file using 'step':'residual' every :::3::3 with linespoints ls 4 title 'uncondensed, unscaled, in m and N'
