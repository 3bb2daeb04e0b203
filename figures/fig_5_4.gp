# Figure 5.4 - the printed ratios among those of readings of the method.   In: fig_5_4.csv, fig_5_4_whole.csv   Out: fig_5_4.svg
height = 960
load 'style.gp'
m(v) = abs(v) < 1e-10 ? 0 : (v > 0 ? 1 : -1) * (log10(abs(v)) + 10)  # a logarithmic axis with two signs
set multiplot
set lmargin 12
set xrange [-0.6:11.6]
set yrange [-10.5:10.5]
set ytics ('+1' 10, '+10^{−2}' 8, '+10^{−4}' 6, '+10^{−6}' 4, '+10^{−8}' 2, '0' 0, '−10^{−8}' -2, '−10^{−6}' -4, '−10^{−4}' -6, '−10^{−2}' -8, '−1' -10)
set grid noxtics
set bars 0
set ylabel '{/:Italic f}_P / {/:Italic f}_L − 1'
place(name) = (name eq 'letter') ? -0.32 : (name eq 'all') ? -0.2 : (name eq 'met') ? -0.08 : (name eq 'loop') ? 0.08 : (name eq 'hundred') ? 0.2 : 0.32
bars(name) = sprintf("using (column('place')%+.2f):(m(column('%s_50'))):(m(column('%s_10'))):(m(column('%s_90')))", place(name), name, name, name)
tics = "'' using 'place':(NaN):xtic(word('10 10 10 10 20 20 20 20 50 50 50 50', int($0)+1).\"\\n\".word('5 10 20 40 10 20 40 80 25 50 100 200', int($0)+1)) notitle"
curves(file, t) = "plot 0 with lines ls 8 notitle, '".file."' ".bars('letter')." with yerrorbars pt 4 ps 0.7 lw 2.5 dt 1 lc rgb PURPLE title ".(t ? "'(28) to the letter'" : "''").", \
  '' ".bars('met')." with yerrorbars pt 6 ps 0.7 lw 2.5 dt 1 lc rgb ORANGE title ".(t ? "'loop, each row once, rows it meets'" : "''").", \
  '' ".bars('all')." with yerrorbars pt 5 ps 0.7 lw 2.5 dt 1 lc rgb RED title ".(t ? "'loop, all violated rows'" : "''").", \
  '' ".bars('loop')." with yerrorbars pt 12 ps 0.8 lw 2.5 dt 1 lc rgb SKY title ".(t ? "'loop, 2/(k+2), 1000 steps each'" : "''").", \
  '' ".bars('hundred')." with yerrorbars pt 9 ps 0.8 lw 2.5 dt 1 lc rgb GREEN title ".(t ? "'weights, 2/(k+2), 100 steps'" : "''").", \
  '' ".bars('thousand')." with yerrorbars pt 7 ps 0.7 lw 2.5 dt 1 lc rgb BLUE title ".(t ? "'weights, 2/(k+2), 1000 steps'" : "''").", \
  '' using 'place':(m(column('paper'))) with points pt 2 ps 1.4 lw 3 lc rgb BLACK title ".(t ? "'printed in table 1'" : "''").", ".tics
set tmargin at screen 0.785
set bmargin at screen 0.48
set key at screen 0.98,0.995 maxrows 7
set label 1 'programmes as in this chapter' at graph 0.01,0.05
eval curves(data.'/fig_5_4.csv', 1)
set tmargin at screen 0.41
set bmargin at screen 0.105
set label 1 'programmes of whole numbers'
set xlabel '{/:Italic n} unknowns above {/:Italic m} rows' offset 0,-0.8
eval curves(data.'/fig_5_4_whole.csv', 0)
unset multiplot
