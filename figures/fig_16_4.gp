# Figure 16.4 - where the seconds go: phases stacked, in plain solves of the same mesh.
# In: fig_16_4.csv   Out: fig_16_4.svg
width = 760; height = 420
load 'style.gp'
set style data histograms
set style histogram rowstacked
set boxwidth 0.7
set key outside right top reverse Left invert noopaque
set rmargin 22
set bmargin 6
set ylabel 'seconds / plain solve'
set label 1 'Hertz' at 1, graph -0.27 center
set label 2 'cantilever' at 4, graph -0.27 center
set yrange [0:*]
set grid noxtics
set xtics scale 0
set arrow 1 from graph 0, first 1 to graph 1, first 1 nohead lw 1.5 dt (6,4) lc rgb BLACK front
file = data.'/fig_16_4.csv'
plot file using 'ordering ≈':xtic(sprintf("%.0fk", column('unknowns')/1e3)) lc rgb BLUE lw 1 dt 1 fs solid 1 border lc rgb BLACK title 'ordering', \
     '' using (column('symbolic ≈')+column('numeric ≈')) lc rgb SKY lw 1 dt 1 fs solid 1 border lc rgb BLACK title 'factor', \
     '' using 'condensation ≈' lc rgb ORANGE lw 1 dt 1 fs pattern 1 border lc rgb BLACK title 'condensation', \
     '' using 'contact ≈' lc rgb RED lw 1 dt 1 fs solid 1 border lc rgb BLACK title 'contact', \
     '' using (column('refinement ≈')+column('recovery ≈')) lc rgb GREEN lw 1 dt 1 fs pattern 2 border lc rgb BLACK title 'refinement', \
     '' using (column('plan ≈')+column('assembly ≈')) lc rgb LIGHT lw 1 dt 1 fs solid 1 border lc rgb BLACK title 'plan, assembly'
