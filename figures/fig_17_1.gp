# Figure 17.1 - who solves which exhibit of the museum: a bar per visitor and room, as long as the room has exhibits.
# In: fig_17_1.csv fig_17_1_rooms.csv   Out: fig_17_1.svg
width = 640; height = 440
load 'style.gp'
set lmargin at screen 0.365; set rmargin at screen 0.985
set tmargin at screen 0.80; set bmargin at screen 0.1
unset border; unset grid; unset xtics
set ytics scale 0 offset 0.8,0
set yrange [11.6:-0.6]
set style fill noborder

# how many exhibits of a room got each verdict, from 0 solved, 1 honest, 2 wrong, of each visitor
array begins[8]; array count[12*7*3]
do for [k = 1:|count|] { count[k] = 0 }
room(exhibit) = sum [k = 2:7] (exhibit >= begins[k])
at(visitor, room, verdict) = 1 + verdict + 3*(room + 7*visitor)
add(k) = (count[k] = count[k] + 1)
set table $none
plot data.'/fig_17_1_rooms.csv' using (begins[int($0) + 1] = column('begins')):(begins[8] = column('ends'))
plot data.'/fig_17_1.csv' using 'exhibit':(column('verdict') < 3 ? add(at(int(column('visitor')), room(column('exhibit')), int(column('verdict')))) : 0)
unset table
gap = 2.5  # between rooms
set xrange [0:begins[8] + 6*gap]

n = 0
do for [visitor = 0:11] { do for [k = 0:6] {
  left = begins[k + 1] + k*gap
  n = n + 1
  set object n rectangle from left,visitor + 0.34 to left + begins[k + 2] - begins[k + 1],visitor + 0.36 fc rgb GREY fs solid noborder
  do for [verdict = 0:2] {
    right = left + count[at(visitor, k, verdict)]
    n = n + 1
    if (right > left && verdict == 0) { set object n rectangle from left,visitor - 0.36 to right,visitor + 0.36 fc rgb BLUE fs solid noborder }
    if (right > left && verdict == 1) { set object n rectangle from left,visitor - 0.36 to right,visitor + 0.36 fc rgb LIGHT fs solid border lc rgb GREY }
    if (right > left && verdict == 2) { set object n rectangle from left,visitor - 0.36 to right,visitor + 0.36 fc rgb RED fs pattern 4 border lc rgb RED }
    left = right
  }
} }
names = "ours small\\_library lemke fischer\\_burmeister quasi\\_active\\_set\\_literal q4 node\\_to\\_segment trial\\_and\\_error penalty soft\\_springs uncoupled lenient\\_reader"
set for [k = 1:12] ytics add (word(names, k) k - 1)
set key at screen 0.97, screen 0.045 right center maxrows 1 samplen 1.5 width -1
plot data.'/fig_17_1_rooms.csv' using (0.5*(column('begins') + column('ends')) + gap*$0):(-0.6):(strcol('room')) with labels rotate by 40 left offset -0.4,0.5 notitle, \
     NaN with boxes fc rgb BLUE fs solid title 'solved', \
     NaN with boxes fc rgb LIGHT fs solid border lc rgb GREY title 'honest', \
     NaN with boxes fc rgb RED fs pattern 4 border lc rgb RED title 'wrong, caught'
