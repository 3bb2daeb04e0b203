# Figure 14.2 - the deformed rings, and the pair of nodes at 40 degrees.
# In: fig_14_2.csv, fig_14_2_lining.csv, fig_14_2_rock.csv   Out: fig_14_2.svg
width = 840; height = 380
load 'style.gp'
set size ratio -1
unset grid
set xlabel '{/:Italic x} [cm]'
set ylabel '{/:Italic y} [cm]' offset 1,0
set xrange [0:79]
set yrange [0:79]
set xtics 20
set ytics 20
set palette maxcolors 14
set cbrange [350:1050]
set multiplot
set lmargin at screen 0.08
set rmargin at screen 0.42
unset key
set object 1 rectangle from 51.1,42.7 to 53.5,45.1 fs empty border lc rgb BLACK lw 1.5 front
set colorbox user origin 0.43,0.27 size 0.018,0.5
set cblabel 'hoop stress [MPa]' offset 0.5,0
set cbtics 350,100
plot data.'/fig_14_2_lining.csv' using 'x':'y':'value' with polygons fs solid noborder fc palette, \
     data.'/fig_14_2_rock.csv' using 'x':'y':'value' with polygons fs solid noborder fc palette, \
     data.'/fig_14_2_lining.csv' using 'x':'y' with lines lc rgb '#60ffffff' lw 0.4 dt 1, \
     data.'/fig_14_2_rock.csv' using 'x':'y' with lines lc rgb '#60ffffff' lw 0.4 dt 1
unset object 1
set lmargin at screen 0.65
set rmargin at screen 0.98
set xrange [51.6:52.5]
set yrange [43.2:44.1]
set xtics 0.2
set ytics 0.2
set key bottom left spacing 1.0
set ylabel '{/:Italic y} [cm]' offset 0,0
set label 1 '10' at 52.02,43.67 font ',11'
set label 2 '80' at 52.17,43.86 font ',11'
set label 3 '10 and 80' at 52.33,43.90 font ',11'
plot data.'/fig_14_2.csv' using 'x':'y' every :::0::0 with linespoints ls 1 dt 1 pt 7 title 'lining, before', \
     '' using 'x':'y' every :::1::1 with linespoints ls 3 pt 9 title 'rock, before', \
     '' using 'x_moved':'y_moved' every :::0::0 with linespoints lc rgb '#60E69F00' lw 6 dt 1 pt 7 ps 1.1 title 'lining, loaded', \
     '' using 'x_moved':'y_moved' every :::1::1 with linespoints ls 7 pt 6 ps 1.4 title 'rock, loaded'
unset multiplot
