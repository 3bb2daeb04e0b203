# Figure 0.1 - the matrix of one square, in twenty-fourths.   In: fig_0_1.csv   Out: fig_0_1.svg
width = 640; height = 560
load 'style.gp'
unset grid
unset key
unset border
unset colorbox
set lmargin 12
set rmargin 2
set tmargin 3.5
set bmargin 0.8
set size ratio -1
set xrange [0.4:8.6]
set yrange [8.6:0.4]
names = "x_1 y_1 x_2 y_2 x_3 y_3 x_4 y_4"
set format x ''
set format y ''
unset xtics
unset ytics
do for [k=1:8] {
  set label k word(names, k) at k,0.1 center textcolor rgb BLACK
  set label 10+k word(names, k) at 0.25,k right textcolor rgb BLACK
}
# a whole number with its sign, 0 without one
signed(v) = v > 0 ? sprintf('+%.0f', v) : v < 0 ? sprintf('−%.0f', -v) : '0'
set palette defined (-12 '#8ec3e6', 0 '#ffffff', 12 '#f2b27a')
set cbrange [-12:12]
plot data.'/fig_0_1.csv' using 'column':'row':(0.5):(0.5):'entry' with boxxyerror fs solid border lc rgb GREY fc palette, \
     '' using 'column':'row':(signed(column('entry'))) with labels textcolor rgb BLACK
