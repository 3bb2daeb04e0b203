# Figure 11.3 - residuals of the printed method, and of this book's.   In: fig_11_3.csv, fig_11_3_chance.csv   Out: fig_11_3.svg
height = 520
load 'style.gp'
set termoption font 'DejaVu Sans,15'
eval LOGY
set xlabel 'steps'
set ylabel 'residual |F| [N, mm]'
set xrange [0:30]
set yrange [1e-17:1e24]
set ytics 1e4
set key top right spacing 1.05
plot data.'/fig_11_3_chance.csv' using 'step':'residual' with linespoints ls 8 title 'points, nodes meet: by chance', \
     data.'/fig_11_3.csv' using 'step':'residual' every :::1::1 with linespoints ls 5 title 'points, nodes do not meet', \
     '' using 'step':'residual' every :::0::0 with linespoints ls 3 title 'points, nodes meet, J mended', \
     '' using 'step':'residual' every :::2::2 with linespoints ls 2 title 'the same equations, nodes', \
     '' using 'step':'residual' every :::3::3 with linespoints ls 1 lw 2.6 title 'nodes, condensed', \
     '' using 'step':'residual' every :::4::4 with points ls 7 pt 3 ps 1.8 lw 2.5 title 'printed in the paper'
