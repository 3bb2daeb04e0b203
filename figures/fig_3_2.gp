# Figure 3.2 - what is missing after k iterations, six rules.   In: fig_3_2.csv   Out: fig_3_2.svg
height = 540
load 'style.gp'
eval LOGLOG
set xlabel 'iteration'
set ylabel '({/:Italic s}* − {/:Italic s}) / {/:Italic s}*'
set xrange [1:2.2e4]
set yrange [1e-9:2]
set tmargin 5
set key at graph 1,1.03 bottom right maxrows 3
file = data.'/fig_3_2.csv'
plot file using 'iteration':'gap' every :::0::0 with linespoints ls 7 title 'literal (28): hops', \
     '' using 'iteration':'gap' every :::1::1 with linespoints ls 2 pi 4 title '2/(k + 2)', \
     '' using 'iteration':'gap' every :::2::2 with linespoints ls 3 pi 4 title 'line search', \
     '' using 'iteration':'gap' every :::3::3 with linespoints ls 4 pi 4 title 'away steps', \
     '' using 'iteration':'gap' every :::4::4 with linespoints ls 5 pi 4 title 'pairwise', \
     '' using 'iteration':'gap' every :::5::5 with linespoints ls 1 pi 4 title 'fully corrective'
