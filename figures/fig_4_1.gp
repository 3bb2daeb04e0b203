# Figure 4.1 - the flow chart of the method with the counts of three runs.   In: fig_4_1.csv   Out: fig_4_1.svg
width = 600; height = 470
load 'style.gp'
unset border; unset tics; unset grid
set lmargin 1; set rmargin 1; set tmargin 1; set bmargin 1
set xrange [0:100]; set yrange [4:100]
set key at 99,10 right bottom Left reverse samplen 2.5

# arrows in the order of the lines of the table: where from, how far, where their counts stand
array X[6] = [22, 43, 59, 22, 22, 43]
array Y[6] = [90, 78, 69, 64, 35, 44]
array DX[6] = [0, 16, -16, 0, 0, 16]
array DY[6] = [-7, 0, 0, -11.5, -12.5, 0]
array LX[6] = [24, 51, 51, 24, 24, 51]
array LY[6] = [86.5, 81.5, 65.5, 58.5, 29, 47.5]
array SAYS[6] = ['', '', '', 'no:  ', 'no:  ', '']
array BEFORE[6] = ['', 'yes', '', '', '', 'yes']
n(i) = int(i)
who(w, r, b) = w > 0 && b > 0 ? 1 : (w > 0 ? 2 : 3)
text(i, w, r, b) = SAYS[n(i)].sprintf('%d | %d | %d', w, r, b)
set style arrow 1 nohead lc rgb BLACK lw 2.5 dt 1
set style arrow 2 nohead lc rgb RED lw 2.5 dt (8,4)
set style arrow 3 nohead lc rgb BLUE lw 2.5 dt (2,3)
set style arrow 4 head filled size graph 0.018,22 lc rgb BLACK lw 2.5 dt 1
set style arrow 5 head filled size graph 0.018,22 lc rgb RED lw 2.5 dt 1
set style arrow 6 head filled size graph 0.018,22 lc rgb BLUE lw 2.5 dt 1

set style rectangle fc rgb '#ffffff' fs solid 1.0 border lc rgb BLACK
set object 1 rectangle center 22,94 size 42,7.5 fc rgb LIGHT
set object 2 rectangle center 22,73.5 size 42,18
set object 3 rectangle center 79.5,73.5 size 41,18 fc rgb LIGHT
set object 4 rectangle center 22,44 size 42,17
set object 5 rectangle center 79.5,44 size 41,17 fc rgb LIGHT
set object 6 rectangle center 22,16.5 size 42,12 fc rgb LIGHT
set label 1 '{/:Italic u}^0 = {/:Italic K}^{–1}{/:Italic p}   (20)' at 22,94 center
set label 2 "VIO: all violated pairs\nis there one?" at 22,75.5 center
set label 3 "QAS among them   (37)\ntheir forces   (38), (39)\nminimum moved   (36)" at 79.5,77.5 center
set label 4 "tight pairs alone,\nfirst energy   (33)\nis another one violated?" at 22,48 center
set label 5 "back to the first pair\nin the way   (34), (35)\noptimal or not" at 79.5,48 center
set label 6 "{/:Italic u}^{/:Italic k+1} is optimal" at 22,16.5 center
set label 7 'four walls | three rows | block' at 79.5,29.5 center
do for [i = 2:6:4] { set label 10+i BEFORE[i] at LX[i],LY[i]+4.2 center }
plot data.'/fig_4_1.csv' using (X[n(column('arrow'))]):(Y[n(column('arrow'))]):(0.75*DX[n(column('arrow'))]):(0.75*DY[n(column('arrow'))]):(who(column('walls'), column('rows'), column('block'))) with vectors arrowstyle variable notitle, \
     '' using (X[n(column('arrow'))]+0.75*DX[n(column('arrow'))]):(Y[n(column('arrow'))]+0.75*DY[n(column('arrow'))]):(0.25*DX[n(column('arrow'))]):(0.25*DY[n(column('arrow'))]):(3+who(column('walls'), column('rows'), column('block'))) with vectors arrowstyle variable notitle, \
     '' using (LX[n(column('arrow'))]):(DX[n(column('arrow'))] == 0 ? LY[n(column('arrow'))] : NaN):(text(column('arrow'), column('walls'), column('rows'), column('block'))) with labels left notitle, \
     '' using (LX[n(column('arrow'))]):(DX[n(column('arrow'))] == 0 ? NaN : LY[n(column('arrow'))]):(text(column('arrow'), column('walls'), column('rows'), column('block'))) with labels center notitle, \
     NaN with lines lc rgb BLACK lw 2.5 dt 1 title 'all three runs', \
     NaN with lines lc rgb RED lw 2.5 dt (8,4) title 'four walls, three rows', \
     NaN with lines lc rgb BLUE lw 2.5 dt (2,3) title 'block of chapter 1'
