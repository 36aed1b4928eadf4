within PneumaticMuscle.UsersGuide;
class References "Every work that the library cites, by the key under which it is cited"
  extends Icons.Information;
  annotation (Documentation(info="<html>
<p>DP, DY and AM are cited by the numbers of their equations, figures and tables; every other work by its authors and
year, written as here: one, two or three names, or the first <code>and others</code>.</p>
<ul>
<li><b>DP</b>: M. D. Doumit, S. Pardoel, <i>Dynamic contraction behaviour of pneumatic artificial muscle</i>, Mechanical
Systems and Signal Processing 91 (2017) 93-110.</li>
<li><b>DY</b>: M. A. Mat Dzahir, S. Yamamoto, <i>Dynamic modeling of McKibben muscle using empirical model and particle
swarm optimization method</i>, Applied Sciences 9 (2019) 2538.</li>
<li><b>AM</b>: <i>Modeling and control of a pneumatic air muscle actuator</i>, slides.</li>
<li><b>Astrom and Hagglund 1995</b>: K. J. Astrom, T. Hagglund, <i>PID controllers: theory, design, and tuning</i>,
second edition, Instrument Society of America, Research Triangle Park 1995.</li>
<li><b>Barrer 1939</b>: R. M. Barrer, <i>Permeation, diffusion and solution of gases in organic polymers</i>,
Transactions of the Faraday Society 35 (1939) 628-643.</li>
<li><b>Bolen and others 2026</b>: B. Bolen, M. Elzein, L. Pang, A. Hunt, <i>Isometric force characterization of braided
pneumatic actuators</i>, Actuators (2026), accepted on 17 April 2026.</li>
<li><b>Budynas and Nisbett 2011</b>: R. G. Budynas, J. K. Nisbett, <i>Shigley's mechanical engineering design</i>, ninth
edition, McGraw-Hill, New York 2011, chapter 16.</li>
<li><b>Chambers and Wereley 2022</b>: J. M. Chambers, N. M. Wereley, <i>Analysis of pneumatic artificial muscles and the
inelastic braid assumption</i>, Actuators 11 (2022) 219.</li>
<li><b>Dahl 1968</b>: P. R. Dahl, <i>A solid friction model</i>, The Aerospace Corporation, report TOR-0158(3107-18)-1,
1968.</li>
<li><b>Dittus and Boelter 1930</b>: F. W. Dittus, L. M. K. Boelter, <i>Heat transfer in automobile radiators of the
tubular type</i>, University of California Publications in Engineering 2 (1930) 443-461.</li>
<li><b>Dymond and Smith 1980</b>: J. H. Dymond, E. B. Smith, <i>The virial coefficients of pure gases and mixtures: a
critical compilation</i>, Clarendon Press, Oxford 1980.</li>
<li><b>EN 837-1</b>: <i>Pressure gauges, part 1: Bourdon tube pressure gauges; dimensions, metrology, requirements and
testing</i>, European Committee for Standardization.</li>
<li><b>Eyring 1936</b>: H. Eyring, <i>Viscosity, plasticity, and diffusion as examples of absolute reaction rates</i>,
Journal of Chemical Physics 4 (1936) 283-291.</li>
<li><b>Ferraresi, Franco and Bertetto 2001</b>: C. Ferraresi, W. Franco, A. M. Bertetto, <i>Flexible pneumatic
actuators: a comparison between the McKibben and the straight fibres muscles</i>, Journal of Robotics and Mechatronics
13 (2001) 56-63.</li>
<li><b>Ferry 1980</b>: J. D. Ferry, <i>Viscoelastic properties of polymers</i>, third edition, Wiley, New York
1980.</li>
<li><b>Festo 2005</b>: Festo AG and Co. KG, <i>Fluidic Muscle DMSP, with press-fitted connections; Fluidic Muscle MAS,
with screwed connections</i>, Info 501, 2005/04.</li>
<li><b>Findley, Lai and Onaran 1976</b>: W. N. Findley, J. S. Lai, K. Onaran, <i>Creep and relaxation of nonlinear
viscoelastic materials</i>, North-Holland, Amsterdam 1976.</li>
<li><b>Forchheimer 1901</b>: P. Forchheimer, <i>Wasserbewegung durch Boden</i>, Zeitschrift des Vereines Deutscher
Ingenieure 45 (1901) 1782-1788.</li>
<li><b>Fung 1967</b>: Y. C. Fung, <i>Elasticity of soft tissues in simple elongation</i>, American Journal of Physiology
213 (1967) 1532-1544.</li>
<li><b>Fung 1981</b>: Y. C. Fung, <i>Biomechanics: mechanical properties of living tissues</i>, Springer, New York
1981.</li>
<li><b>Gaylord 1958</b>: R. H. Gaylord, <i>Fluid actuated motor system and stroking device</i>, US patent 2 844 126,
1958.</li>
<li><b>Gent 2012</b>: A. N. Gent, <i>Engineering with rubber: how to design rubber components</i>, third edition,
Hanser, Munich 2012.</li>
<li><b>Helmholtz 1863</b>: H. von Helmholtz, <i>Die Lehre von den Tonempfindungen</i>, Vieweg, Braunschweig 1863.</li>
<li><b>Hildebrandt and others 2005</b>: A. Hildebrandt, O. Sawodny, R. Neumann, A. Hartmann, <i>Cascaded control concept
of a robot with two degrees of freedom driven by four artificial pneumatic muscle actuators</i>, Proceedings of the
American Control Conference, Portland 2005, 680-685.</li>
<li><b>Hunt, Graber-Tilton and Quinn 2017</b>: A. Hunt, A. Graber-Tilton, R. Quinn, <i>Modeling length effects of
braided pneumatic actuators</i>, ASME International Design Engineering Technical Conferences, Cleveland 2017,
V05AT08A008.</li>
<li><b>IEC 60584</b>: <i>Thermocouples, part 1: EMF specifications and tolerances</i>, International Electrotechnical
Commission, 2013.</li>
<li><b>IEC 61298</b>: <i>Process measurement and control devices, general methods and procedures for evaluating
performance</i>, International Electrotechnical Commission, 2008.</li>
<li><b>ISO 10041</b>: <i>Pneumatic fluid power: electro-pneumatic continuous flow control valves</i>, International
Organization for Standardization.</li>
<li><b>ISO 10094</b>: <i>Pneumatic fluid power: electro-pneumatic continuous pressure control valves</i>, International
Organization for Standardization.</li>
<li><b>ISO 6358</b>: <i>Pneumatic fluid power: determination of flow-rate characteristics of components using
compressible fluids</i>, International Organization for Standardization.</li>
<li><b>ISO 6801</b>: <i>Rubber or plastics hoses: determination of volumetric expansion</i>, International Organization
for Standardization.</li>
<li><b>ISO 6953</b>: <i>Pneumatic fluid power: compressed air pressure regulators and filter-regulators</i>,
International Organization for Standardization.</li>
<li><b>Itto and Kogiso 2011</b>: T. Itto, K. Kogiso, <i>Hybrid modeling of McKibben pneumatic artificial muscle
systems</i>, Proceedings of the IEEE International Conference on Industrial Technology, Auburn 2011, 65-70.</li>
<li><b>Kang and others 2009</b>: B. S. Kang, C. S. Kothera, B. K. S. Woods, N. M. Wereley, <i>Dynamic modeling of
McKibben pneumatic artificial muscles for antagonistic actuation</i>, Proceedings of the IEEE International Conference
on Robotics and Automation, Kobe 2009, 182-187.</li>
<li><b>Kerlin, Miller and Hashemian 1978</b>: T. W. Kerlin, L. F. Miller, H. M. Hashemian, <i>In-situ response time
testing of platinum resistance thermometers</i>, ISA Transactions 17 (1978).</li>
<li><b>Kerscher and others 2006</b>: T. Kerscher, J. Albiez, J. M. Zollner, R. Dillmann, <i>Evaluation of the dynamic
model of fluid muscles using quick-release</i>, Proceedings of the IEEE/RAS-EMBS International Conference on Biomedical
Robotics and Biomechatronics, Pisa 2006.</li>
<li><b>King 1914</b>: L. V. King, <i>On the convection of heat from small cylinders in a stream of fluid</i>,
Philosophical Transactions of the Royal Society A 214 (1914) 373-432.</li>
<li><b>Martens and Boblan 2017</b>: M. Martens, I. Boblan, <i>Modeling the static force of a Festo pneumatic muscle
actuator: a new approach and a comparison to existing models</i>, Actuators 6 (2017) 33.</li>
<li><b>Martin 1977</b>: H. Martin, <i>Heat and mass transfer between impinging gas jets and solid surfaces</i>, Advances
in Heat Transfer 13 (1977) 1-60.</li>
<li><b>McAdams 1954</b>: W. H. McAdams, <i>Heat transmission</i>, third edition, McGraw-Hill, New York 1954.</li>
<li><b>Merritt 1967</b>: H. E. Merritt, <i>Hydraulic control systems</i>, Wiley, New York 1967.</li>
<li><b>Mueller and Nau 1998</b>: H. K. Mueller, B. S. Nau, <i>Fluid sealing technology: principles and
applications</i>, Marcel Dekker, New York 1998.</li>
<li><b>Olsson and others 1998</b>: H. Olsson, K. J. Astrom, C. Canudas de Wit, M. Gafvert, P. Lischinsky, <i>Friction
models and friction compensation</i>, European Journal of Control 4 (1998) 176-195.</li>
<li><b>Perry 1949</b>: J. A. Perry, <i>Critical flow through sharp-edged orifices</i>, Transactions of the ASME 71
(1949) 757-764.</li>
<li><b>Reese and Govindjee 1998</b>: S. Reese, S. Govindjee, <i>A theory of finite viscoelasticity and numerical
aspects</i>, International Journal of Solids and Structures 35 (1998) 3455-3482.</li>
<li><b>Reynolds and others 2003</b>: D. B. Reynolds, D. W. Repperger, C. A. Phillips, G. Bandry, <i>Modeling the dynamic
characteristics of pneumatic muscle</i>, Annals of Biomedical Engineering 31 (2003) 310-317.</li>
<li><b>Sarosi 2012</b>: J. Sarosi, <i>New approximation algorithm for the force of fluidic muscles</i>, Proceedings of
the IEEE International Symposium on Applied Computational Intelligence and Informatics, Timisoara 2012, 229-233.</li>
<li><b>Sarosi and Fabulya 2012</b>: J. Sarosi, Z. Fabulya, <i>Mathematical analysis of the function approximation for
the force generated by pneumatic artificial muscle</i>, Scientific Bulletin of the Politehnica University of Timisoara,
Transactions on Mechanics 57 (2012) 59-64.</li>
<li><b>Scadron and Warshawsky 1952</b>: M. D. Scadron, I. Warshawsky, <i>Experimental determination of time constants
and Nusselt numbers for bare-wire thermocouples in high-velocity air streams and analytic approximation of conduction
and radiation errors</i>, NACA Technical Note 2599, 1952.</li>
<li><b>Schulte 1961</b>: H. F. Schulte, <i>The characteristics of the McKibben artificial muscle</i>, in: The
application of external power in prosthetics and orthetics, National Academy of Sciences, Washington 1961.</li>
<li><b>Shapiro 1953</b>: A. H. Shapiro, <i>The dynamics and thermodynamics of compressible fluid flow</i>, Ronald Press,
New York 1953.</li>
<li><b>Sorge 2015</b>: F. Sorge, <i>Dynamical behaviour of pneumatic artificial muscles</i>, Meccanica 50 (2015)
1371-1386.</li>
<li><b>Stribeck 1902</b>: R. Stribeck, <i>Die wesentlichen Eigenschaften der Gleit- und Rollenlager</i>, Zeitschrift des
Vereines Deutscher Ingenieure 46 (1902).</li>
<li><b>Tondu, Boitier and Lopez 1994</b>: B. Tondu, V. Boitier, P. Lopez, <i>Naturally compliant robot-arms actuated by
McKibben artificial muscles</i>, Proceedings of the IEEE International Conference on Systems, Man and Cybernetics, San
Antonio 1994, 2635-2640.</li>
<li><b>Tothova and Pitel 2013</b>: M. Tothova, J. Pitel, <i>Dynamic model of pneumatic actuator based on advanced
geometric muscle model</i>, Proceedings of the IEEE International Conference on Computational Cybernetics, Tihany 2013,
83-87.</li>
<li><b>Vo-Minh and others 2011</b>: T. Vo-Minh, T. Tjahjowidodo, H. Ramon, H. Van Brussel, <i>A new approach to modeling
hysteresis in a pneumatic artificial muscle using the Maxwell-slip model</i>, IEEE/ASME Transactions on Mechatronics 16
(2011) 177-186.</li>
<li><b>Wang, Wereley and Pillsbury 2015</b>: G. Wang, N. M. Wereley, T. Pillsbury, <i>Non-linear quasi-static model of
pneumatic artificial muscle actuators</i>, Journal of Intelligent Material Systems and Structures 26 (2015)
541-553.</li>
<li><b>Wickramatunge and Leephakpreeda 2010</b>: K. C. Wickramatunge, T. Leephakpreeda, <i>Study on mechanical behaviors
of pneumatic artificial muscle</i>, International Journal of Engineering Science 48 (2010) 188-198.</li>
<li><b>Woods and others 2014</b>: B. K. S. Woods, C. S. Kothera, G. Wang, N. M. Wereley, <i>Dynamics of a pneumatic
artificial muscle actuation system driving a trailing edge flap</i>, Smart Materials and Structures 23 (2014)
095014.</li>
</ul>
<p>What is known here through DP or DY only is cited with the number that it has there, so Cao's models, reference 20 of
DP. DY's list spells Boitier as Boiter, Vo-Minh as Minh. A law that goes by its finder's name alone, such as Hooke's or
Blasius', is no citation.</p>
<p>Where a printed equation could not be used as it stands, the class that implements it says what was changed and
why; <code>docs/validation.md</code> lists all of them.</p>
</html>"));
end References;
