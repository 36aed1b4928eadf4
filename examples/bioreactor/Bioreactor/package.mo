package Bioreactor "Microbes that grow in a stirred, fed vessel, and the rates that a simple model of them leaves out"
  annotation (version="1.0.0", Documentation(info="<html>
<p>Balances of an ideally mixed vessel, with an unstructured and unsegregated culture. SI units throughout; 1 kg/m3 is 1 g/l.</p>
<p>Source of the balances: J. E. Bailey, D. F. Ollis, <i>Biochemical Engineering Fundamentals</i>, 2nd ed., 1986, chapters 7 and 9;
as in A. Strouwen, S. Micluța-Câmpeanu, <i>Experimental Design for Missing Physics</i>, arXiv:2604.01231.</p>
</html>"));
end Bioreactor;
