# Figure 15.3 - what sticks and what slides: above the push over time, below the places of the contact.
# In: fig_15_3.csv, fig_15_3_edge.csv   Out: fig_15_3.svg
width = 640; height = 480
load 'style.gp'
set lmargin 10; set rmargin 2
set xrange [1:6]
set xtics ('' 1, '' 2, '' 3, '' 4, '' 5, '' 6)
unset key
set multiplot
set tmargin at screen 0.97; set bmargin at screen 0.76
set ylabel '{/:Italic Q} / {/:Italic μP}' offset 1,0
set yrange [-0.8:0.8]
set ytics ('0.6' 0.6, '0' 0, '−0.6' -0.6)
push(time) = 0.6*(time < 2 ? time - 1 : (time < 4 ? 3 - time : time - 5))
plot push(x) with lines ls 7 lw 2.5
set tmargin at screen 0.72; set bmargin at screen 0.12
set ylabel '{/:Italic x} [mm]'
set yrange [-0.82:0.82]
set ytics 0.4
set xtics ('pushed forth' 1.5, 'the push turns' 3, 'and turns again' 5) scale 0
set grid noxtics noytics
do for [turn = 1:2] { set arrow turn from 2*turn,-0.82 to 2*turn,0.82 nohead front lc rgb BLACK lw 1 dt (6,4) }
set label 1 'sticks' at 2.15,0 left front textcolor rgb '#ffffff' 
do for [s = -1:1:2] {
  set label 12 + s 'forth' at 1.66,0.69*s center front
  set label 22 + s 'slides back' at 3.45,0.69*s center front
  set label 32 + s 'slides forth' at 5.45,0.69*s center front
}
file = data.'/fig_15_3.csv'
is(name) = strcol('motion') eq name ? column('x') : NaN
low(half) = column('x') - half*column('width')/2
step = 1.0/6
plot file using 'time':(is('stick')):(column('time')-step):'time':(low(1)):(low(-1)) with boxxyerror fc rgb BLUE, \
     file using 'time':(is('forward')):(column('time')-step):'time':(low(1)):(low(-1)) with boxxyerror fc rgb ORANGE, \
     file using 'time':(is('backward')):(column('time')-step):'time':(low(1)):(low(-1)) with boxxyerror fc rgb LIGHT, \
     data.'/fig_15_3_edge.csv' using 'time':'stuck' with lines ls 7 lw 2, \
     '' using 'time':(-column('stuck')) with lines ls 7 lw 2
unset multiplot
