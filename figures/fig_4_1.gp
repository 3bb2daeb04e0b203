# Figure 4.1 - the flow chart of the method with the counts of two runs.   In: fig_4_1.csv   Out: fig_4_1.svg
width = 760; height = 470
load 'style.gp'
unset border; unset tics; unset grid
set lmargin 1; set rmargin 1; set tmargin 1; set bmargin 1
set xrange [0:100]; set yrange [4:100]
set key at 98,10 right bottom Left reverse

# arrows in the order of the lines of the table: where from, how far, where their counts stand
array X[6] = [24, 44, 58, 24, 24, 44]
array Y[6] = [90, 78, 69, 64, 35, 44]
array DX[6] = [0, 14, -14, 0, 0, 14]
array DY[6] = [-7, 0, 0, -11.5, -12.5, 0]
array LX[6] = [25.5, 46, 46.5, 25.5, 25.5, 46]
array LY[6] = [86.5, 81, 65.5, 58.5, 29, 47]
array SAYS[6] = ['', 'yes ', '', 'no ', 'no ', 'yes ']
n(i) = int(i)
who(w, b) = w > 0 && b > 0 ? 1 : (w > 0 ? 2 : 3)
set style arrow 1 nohead lc rgb BLACK lw 2.5 dt 1
set style arrow 2 nohead lc rgb RED lw 2.5 dt (8,4)
set style arrow 3 nohead lc rgb BLUE lw 2.5 dt (2,3)
set style arrow 4 head filled size graph 0.016,22 lc rgb BLACK lw 2.5 dt 1
set style arrow 5 head filled size graph 0.016,22 lc rgb RED lw 2.5 dt 1
set style arrow 6 head filled size graph 0.016,22 lc rgb BLUE lw 2.5 dt 1

set style rectangle fc rgb '#ffffff' fs solid 1.0 border lc rgb BLACK
set object 1 rectangle center 24,94 size 40,7.5 fc rgb LIGHT
set object 2 rectangle center 24,73.5 size 40,18
set object 3 rectangle center 78,73.5 size 40,18 fc rgb LIGHT
set object 4 rectangle center 24,44 size 40,17
set object 5 rectangle center 78,44 size 40,17 fc rgb LIGHT
set object 6 rectangle center 24,16.5 size 40,12 fc rgb LIGHT
set label 1 '{/:Italic u}^0 = {/:Italic K}^{–1}{/:Italic p}   (20)' at 24,94 center
set label 2 "VIO: all pairs that {/:Italic u}^{/:Italic k} violates\nis there one?" at 24,75.5 center
set label 3 "QAS = VIO   (37)\nforces of these alone   (38), (39)\n{/:Italic u}^{/:Italic k+1} by (36), then {/:Italic k} ← {/:Italic k} + 1" at 78,77.5 center
set label 4 "the tight pairs alone, with\nthe first energy   (33)\ndoes {/:Italic u}^{/:Italic k+1} violate a pair?" at 24,48 center
set label 5 "towards {/:Italic u}^{/:Italic k+1} as far as\npossible   (34), (35)\nfeasible, not optimal" at 78,48 center
set label 6 "{/:Italic u}^{/:Italic k+1} is optimal" at 24,16.5 center
set label 7 "Counts: four walls in space | block of chapter 1" at 98,27.5 right font ',12'
plot data.'/fig_4_1.csv' using (X[n(column('arrow'))]):(Y[n(column('arrow'))]):(0.75*DX[n(column('arrow'))]):(0.75*DY[n(column('arrow'))]):(who(column('walls'), column('block'))) with vectors arrowstyle variable notitle, \
     '' using (X[n(column('arrow'))]+0.75*DX[n(column('arrow'))]):(Y[n(column('arrow'))]+0.75*DY[n(column('arrow'))]):(0.25*DX[n(column('arrow'))]):(0.25*DY[n(column('arrow'))]):(3+who(column('walls'), column('block'))) with vectors arrowstyle variable notitle, \
     '' using (LX[n(column('arrow'))]):(LY[n(column('arrow'))]):(SAYS[n(column('arrow'))].sprintf('%d | %d', column('walls'), column('block'))) with labels left notitle, \
     NaN with lines lc rgb BLACK lw 2.5 dt 1 title 'both runs', \
     NaN with lines lc rgb RED lw 2.5 dt (8,4) title 'only the four walls', \
     NaN with lines lc rgb BLUE lw 2.5 dt (2,3) title 'only the block'
