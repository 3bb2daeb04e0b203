# style.gp: one look for all figures.  A figure script begins with   load 'style.gp'   and reads its curves
# by the names of their columns:   plot data.'/fig_6_1.csv' using 'x':'p' with lines ls 1 title '...'
# tools/figure.sh passes `out` (the picture) and `data` (the folder with the csv files); by hand, in this
# folder,   gnuplot fig_6_1.gp   takes the csv files beside the script and draws figure.svg.
# A script may set `width` and `height` [pixels] before it loads this file.  Letters are a fortieth of the
# width: 10 pixels high on a page 400 pixels wide, in every figure.
#
# Colours are Okabe and Ito's, distinguishable with all common forms of colour blindness.  Curves also
# differ in dashes and points, so that a print in grey stays readable.

set encoding utf8
if (!exists("out")) out = 'figure.svg'
if (!exists("data")) data = '.'
if (!exists("width")) width = 640
if (!exists("height")) height = 400
set terminal svg size width,height dynamic font sprintf('DejaVu Sans,%g', width/40.0) linewidth 1 background '#ffffff'
set output out

# csv: comment lines begin with #, then one line with the names of the columns, then the rows.  A single
# blank line separates blocks (every :::1::1 is the second); after two blank lines the names are lost.
set datafile separator ','
set datafile commentschars '#'

BLUE = '#0072B2'; RED = '#D55E00'; GREEN = '#009E73'; PURPLE = '#CC79A7'
ORANGE = '#E69F00'; SKY = '#56B4E9'; BLACK = '#222222'; GREY = '#8a8a8a'; LIGHT = '#e4e4e4'

# 1-6 curves, 7 reference values (closed forms, printed numbers), 8 what is only there for orientation
set linetype 1 lc rgb BLUE   lw 2   dt 1          pt 7  ps 0.7
set linetype 2 lc rgb RED    lw 2   dt (12,4)     pt 5  ps 0.7
set linetype 3 lc rgb GREEN  lw 2   dt (4,3)      pt 9  ps 0.9
set linetype 4 lc rgb PURPLE lw 2   dt (12,3,3,3) pt 13 ps 0.9
set linetype 5 lc rgb ORANGE lw 2   dt (8,3)      pt 6  ps 0.8
set linetype 6 lc rgb SKY    lw 2   dt (2,3)      pt 4  ps 0.8
set linetype 7 lc rgb BLACK  lw 1.5 dt 1          pt 8  ps 0.8
set linetype 8 lc rgb GREY   lw 1.2 dt (6,4)      pt 12 ps 0.8
set linetype cycle 8

# gnuplot 6 dashes the axes and borders the fills unless it is told not to
set style line 100 lc rgb BLACK lw 1 dt 1        # frame
set style line 101 lc rgb LIGHT lw 0.8 dt 1      # grid
set style line 102 lc rgb '#f2f2f2' lw 0.6 dt 1  # fine grid
set style fill solid 1.0 noborder
set border 3 back ls 100
set tics nomirror out scale 0.6 textcolor rgb BLACK
set grid xtics ytics back ls 101
set key top right Left reverse opaque samplen 2.5 spacing 1.15 nobox textcolor rgb BLACK
set title textcolor rgb BLACK
set xlabel textcolor rgb BLACK
set ylabel textcolor rgb BLACK
set lmargin 9
set rmargin 3
set samples 601

# Ordered in lightness, for fields.
set palette defined (0 '#00204d', 0.17 '#0f3b6e', 0.33 '#414d6b', 0.5 '#7b7b78', 0.67 '#a69d75', 0.83 '#d3c164', 1 '#ffea46')

# Special diagrams: eval LOGLOG
LOGLOG = 'set logscale xy; set format xy "10^{%T}"; set grid xtics ytics mxtics mytics back ls 101, ls 102; set mxtics 10; set mytics 10'
LOGY   = 'set logscale y; set format y "10^{%T}"; set grid xtics ytics mytics back ls 101, ls 102; set mytics 10'

# Labels on lines: `with labels textcolor rgb BLACK @HALO` has white behind them
set style textbox 1 opaque noborder fillcolor rgb '#ffffff' margins 0.3,0.3
HALO = 'boxed bs 1'
