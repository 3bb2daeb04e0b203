# Figure 4.1 - the flow chart of the method, and how often three runs took its ways.   In: fig_4_1.csv   Out: fig_4_1.svg
width = 640; height = 560
load 'style.gp'
unset border; unset tics; unset grid; unset key
set lmargin 0; set rmargin 0; set tmargin 0; set bmargin 0
set xrange [0:100]; set yrange [0:100]
set style rectangle fc rgb '#ffffff' fs solid 1.0 border lc rgb BLACK
set style arrow 1 head filled size 2,20 lc rgb BLACK lw 2 dt 1
set style arrow 2 nohead lc rgb BLACK lw 2 dt 1
set style arrow 3 nohead lc rgb GREY lw 1 dt 1

set object 1 rectangle center 24,95 size 40,7 fc rgb LIGHT
set label 1 '{/:Italic u}^0 = {/:Italic K}^{–1}{/:Italic p}   (20)' at 24,95 center
set arrow 1 from 24,91.5 to 24,83.5 as 1
set object 2 rectangle center 24,77 size 40,13
set label 2 "VIO: all violated pairs\nis there one?" at 24,79 center
set arrow 2 from 44,77 to 56,77 as 1
set label 3 'yes' at 50,79.3 center
set object 3 rectangle center 77,77 size 42,17 fc rgb LIGHT
set label 4 "QAS among them   (37)\ntheir forces   (38), (39)\nminimum moved   (36)" at 77,81.4 center
set arrow 3 from 77,85.5 to 77,95 as 2
set arrow 4 from 77,95 to 50,95 as 2
set arrow 5 from 50,95 to 50,87.5 as 2
set arrow 6 from 50,87.5 to 24,87.5 as 1
set label 5 '{/:Bold A}' at 79.5,92 center textcolor rgb RED
set arrow 7 from 24,70.5 to 24,60.5 as 1
set label 6 'no' at 26,65.5 left
set object 4 rectangle center 24,52 size 40,17
set label 7 "tight pairs alone,\nfirst energy   (33)\nis another one violated?" at 24,56.4 center
set arrow 8 from 44,52 to 56,52 as 1
set label 8 'yes' at 50,54.3 center
set label 9 '{/:Bold C}' at 50,49.3 center textcolor rgb RED
set object 5 rectangle center 77,52 size 42,17 fc rgb LIGHT
set label 10 "back to the first pair\nin the way   (34), (35):\noptimal or not" at 77,56.4 center
set arrow 9 from 24,43.5 to 24,35 as 1
set label 11 'no' at 26,39.3 left
set label 12 '{/:Bold B}' at 20.5,39.3 center textcolor rgb RED
set object 6 rectangle center 24,31.5 size 40,7 fc rgb LIGHT
set label 13 '{/:Italic u}^{/:Italic k+1} is optimal' at 24,31.5 center

set label 20 'how often' at 3,22 left
set label 21 'four walls' at 58,22 right
set label 22 'three rows' at 77,22 right
set label 23 'block' at 96,22 right
set arrow 20 from 3,19 to 97,19 as 3
# arrows: 1 from the start, 2 to QAS, 3 back from it, 4 down to (33), 5 to the end, 6 to the first pair in the way
row(arrow) = arrow == 2 ? 15 : (arrow == 5 ? 9 : (arrow == 6 ? 3 : NaN))
says(arrow) = arrow == 2 ? '{/:Bold A}  round the loop' : (arrow == 5 ? '{/:Bold B}  optimal at once' : '{/:Bold C}  back to a pair')
plot data.'/fig_4_1.csv' using (3):(row(column('arrow'))):(says(column('arrow'))) with labels left, \
     '' using (58):(row(column('arrow'))):(sprintf('%d', column('walls'))) with labels right, \
     '' using (77):(row(column('arrow'))):(sprintf('%d', column('rows'))) with labels right, \
     '' using (96):(row(column('arrow'))):(sprintf('%d', column('block'))) with labels right
