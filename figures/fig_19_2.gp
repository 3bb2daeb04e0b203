# Figure 19.2 - five methods over six decades of their parameters: error, condition number, passes.
# In: fig_19_2_penalty.csv, fig_19_2_uzawa.csv, fig_19_2_augmented.csv, fig_19_2_nitsche.csv, fig_19_2_active.csv
# Out: fig_19_2.svg
width = 640; height = 900
load 'style.gp'
eval LOGLOG
set multiplot
set lmargin at screen 0.15
set rmargin at screen 0.96
set xrange [1e-2:1e4]
set format x ''
set xlabel ''
penalty = data.'/fig_19_2_penalty.csv'
uzawa = data.'/fig_19_2_uzawa.csv'
augmented = data.'/fig_19_2_augmented.csv'
nitsche = data.'/fig_19_2_nitsche.csv'
active = data.'/fig_19_2_active.csv'
unset key
set tmargin at screen 0.985
set bmargin at screen 0.70
set ylabel 'error [%]' offset 1,0
set format y '%g'
set yrange [10:100]
set ytics (10, 20, 50, 100)
plot active using 'parameter':(100*column('error')) with lines ls 7, \
     penalty using 'parameter':(100*column('error')) with linespoints ls 1, \
     uzawa using 'parameter':(100*column('error')) with linespoints ls 2, \
     augmented using 'parameter':(100*column('error')) with linespoints ls 3, \
     nitsche using 'parameter':(100*column('error')) with linespoints ls 4
set tmargin at screen 0.675
set bmargin at screen 0.42
set ylabel 'condition number'
set ytics auto
set format y "10^{%T}"
set yrange [3e2:3e6]
plot active using 'parameter':'condition' with lines ls 7, \
     penalty using 'parameter':'condition' with linespoints ls 1, \
     uzawa using 'parameter':'condition' with linespoints ls 2, \
     nitsche using 'parameter':'condition' with linespoints ls 4
set tmargin at screen 0.395
set bmargin at screen 0.205
set ylabel 'passes'
set yrange [1:5000]
set format x "10^{%T}"
set xlabel 'parameter, in E over the size of a cell'
set key at screen 0.06,0.02 left bottom maxrows 3 samplen 2.5 noopaque
plot active using 'parameter':'passes' with lines ls 7 title 'active set', \
     penalty using 'parameter':'passes' with linespoints ls 1 title 'penalty', \
     uzawa using 'parameter':'passes' with linespoints ls 2 title 'Uzawa', \
     augmented using 'parameter':'passes' with linespoints ls 3 title 'augmented Lagrangian', \
     nitsche using 'parameter':'passes' with linespoints ls 4 title 'Nitsche'
unset multiplot
