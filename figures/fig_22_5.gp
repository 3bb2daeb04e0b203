# Figure 22.5 - the force on a block that is pressed flat between smooth plates, by three laws.
# In: fig_22_5.csv, fig_22_5_exact.csv   Out: fig_22_5.svg
load 'style.gp'
exact = data.'/fig_22_5_exact.csv'
points = data.'/fig_22_5.csv'
of(name) = strcol('law') eq name ? column('force') : NaN
set xlabel 'height over height before'
set ylabel 'force / ({/:Italic E} · width)' offset 1,0
set xrange [1:0.4]
set xtics 0.1
set yrange [0:1.5]
set key top left Left reverse
plot exact using 'height':'small' with lines ls 7 title 'small strain', \
     exact using 'height':'neo_hooke' with lines ls 1 title 'neo-Hooke', \
     points using 'height':(of('neo_hooke')) with points ls 1 notitle, \
     exact using 'height':'st_venant' with lines ls 2 title 'St Venant-Kirchhoff', \
     points using 'height':(of('st_venant_kirchhoff')) with points ls 2 notitle
