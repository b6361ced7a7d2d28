import re,subprocess
out=subprocess.run(['llvm-objdump-22','-d','--no-show-raw-insn','/tmp/w/firmware/target/thumbv7em-none-eabihf/firmware/calib-firmware'],capture_output=True,text=True).stdout
f=None;r=[]
for l in out.splitlines():
    m=re.match(r'[0-9a-f]+ <(.*)>:',l)
    if m: f=m.group(1)
    m=re.search(r'\bsub(?:w|\.w)?\s+sp,(?: sp,)? #(0x[0-9a-f]+|\d+)',l)
    if m and int(m.group(1),0)>1800: r.append((int(m.group(1),0),f[:150]))
for x in sorted(r,reverse=True)[:12]: print(x)
