#!/bin/sh
# subset.sh: makes the faces of this folder anew, from Debian's packages fonts-texgyre, fonts-texgyre-math, fonts-inconsolata and
# fonts-lato, with python3-fonttools and python3-brotli: only the signs that the book uses. Licences: README.
set -eu
cd "$(dirname "$0")"
subset() { /usr/bin/python3 -m fontTools.subset "$1" --unicodes="$3" --layout-features="$4" --name-IDs=0,13,14 --flavor=woff2 --output-file="$2.woff2"; }
tex=/usr/share/texmf/fonts/opentype/public
lato=/usr/share/fonts/truetype/lato
latin="U+20-7E,U+A0-FF,U+106-107,U+10C-10D,U+141-142,U+150-153,U+160-161,U+17D-17E,U+2010-2027,U+2030-203A,U+2190-2193,U+2202,U+2206,U+2212,U+2215,U+2248,U+2260,U+2264-2265,U+391-3C9,U+2070-2079"
math="U+20-7E,U+A0-FF,U+302-308,U+391-3D6,U+3F5,U+2016,U+2026,U+2032,U+2061,U+2102-2124,U+2190-2194,U+21D2,U+2200-2208,U+220F-222B,U+223C,U+2248,U+2260-2265,U+22C5,U+22EF,U+2308-230B,U+239B-23B3,U+27E8-27E9,\
U+1D434-1D467,U+1D6E2-1D71B,U+210E,U+2C6,U+2DC,U+2D9"
for face in regular:text italic:italic bold:bold; do
    subset $tex/tex-gyre/texgyrepagella-${face%:*}.otf ${face#*:} "$latin" kern,liga,onum,lnum,tnum,pnum,smcp
done
subset $tex/tex-gyre-math/texgyrepagella-math.otf math "$math" ssty,kern
subset /usr/share/fonts/truetype/inconsolata/Inconsolata.otf code "$latin" kern
subset $lato/Lato-Regular.ttf sans "$latin" kern,liga,tnum,lnum,pnum
subset $lato/Lato-Bold.ttf sans-bold "$latin" kern,liga,tnum,lnum,pnum
