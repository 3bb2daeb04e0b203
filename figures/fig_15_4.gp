# Figure 15.4 - shear in the end, for three ways to the same end.   In: fig_15_4.csv   Out: fig_15_4.svg
load 'style.gp'
set xrange [-1:1]; set yrange [-0.4:5.6]
set xlabel '{/:Italic x} [mm]'
set ylabel 'shear on the plate [MPa]'
set tmargin 3.4
set key at graph 0.5,1.2 center top horizontal maxrows 2
file = data.'/fig_15_4.csv'
plot file every :::0::0 using 'x':'bound' with lines ls 8 title '{/:Italic μ} times pressure', \
     file every :::0::0 using 'x':'shear' with linespoints ls 1 title 'down first', \
     file every :::2::2 using 'x':'shear' with linespoints ls 2 title 'straight', \
     file every :::1::1 using 'x':'shear' with linespoints ls 3 title 'aside first'
