# Figure 0.4 - the patch test: nine crooked cells before and after a uniform strain.
# In: fig_0_4.csv, fig_0_4_after.csv   Out: fig_0_4.svg
height = 420
load 'style.gp'
unset grid
unset border
unset tics
set key outside right center width -1
set lmargin 1
set rmargin 1
set bmargin 0.8
set tmargin 0.8
set xrange [-0.2:4.2]
set yrange [-0.4:3.3]
set size ratio -1
plot data.'/fig_0_4.csv' using 'x':'y' with lines ls 8 title 'before', \
     data.'/fig_0_4_after.csv' using 'x':'y' with linespoints ls 1 pt 7 ps 0.7 title 'after'
