# Figure 0.2 - the matrix of two squares side by side, in twenty-fourths; frames: what each square adds.
# In: fig_0_2.csv   Out: fig_0_2.svg
width = 640; height = 640
load 'style.gp'
unset grid
unset key
unset border
unset colorbox
set lmargin 10
set rmargin 2
set tmargin 3.5
set bmargin 0.8
set size ratio -1
set xrange [0.4:12.6]
set yrange [12.6:0.4]
unset xtics
unset ytics
do for [k=1:6] {
  set label 4*k sprintf('x_%d', k) at 2*k-1,0.1 center textcolor rgb BLACK
  set label 4*k+1 sprintf('y_%d', k) at 2*k,0.1 center textcolor rgb BLACK
  set label 4*k+2 sprintf('x_%d', k) at 0.25,2*k-1 right textcolor rgb BLACK
  set label 4*k+3 sprintf('y_%d', k) at 0.25,2*k right textcolor rgb BLACK
}
# nodes 2 and 5 belong to both squares
do for [i=0:1] { do for [j=0:1] {
  set object 1+2*i+j rectangle from (i?8.5:2.5),(j?8.5:2.5) to (i?10.5:4.5),(j?10.5:4.5) front fs empty border lc rgb RED lw 2.5
} }
# a whole number with its sign, 0 without one
signed(v) = v > 0 ? sprintf('+%.0f', v) : v < 0 ? sprintf('−%.0f', -v) : '0'
set palette defined (-12 '#8ec3e6', 0 '#ffffff', 12 '#f2b27a', 24 '#e08a3c')
set cbrange [-12:24]
plot data.'/fig_0_2.csv' using 'column':'row':(0.5):(0.5):'entry' with boxxyerror fs solid border lc rgb LIGHT fc palette, \
     '' using 'column':'row':(column('entry') == 0 ? '·' : signed(column('entry'))) with labels textcolor rgb BLACK
