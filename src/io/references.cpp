// SPDX-License-Identifier: BSD-3-Clause
#include "references.hpp"

namespace brinell::io::references
{

using Kind = Reference::Kind;

Reference anderson_1965()
{
  return {.key = "anderson1965",
          .authors = {"Anderson, D. G."},
          .year = 1965,
          .title = "Iterative procedures for nonlinear integral equations",
          .container = "Journal of the ACM",
          .volume = "12",
          .number = "4",
          .pages = "547-560",
          .doi = "10.1145/321296.321305"};
}

Reference armstrong_1966()
{
  return {.key = "armstrong1966",
          .kind = Kind::report,
          .authors = {"Armstrong, P. J.", "Frederick, C. O."},
          .year = 1966,
          .title = "A mathematical representation of the multiaxial Bauschinger effect",
          .container = "Central Electricity Generating Board, Berkeley Nuclear Laboratories",
          .number = "RD/B/N 731",
          .doi = "10.1179/096034007X207589",
          .note = "Reprinted in Materials at High Temperatures 24 (2007), 1-26, to which the DOI leads"};
}

Reference boucly_2006()
{
  return {
      .key = "boucly2006",
      .kind = Kind::proceedings,
      .authors = {"Boucly, V.", "Nélias, D.", "Green, I."},
      .year = 2006,
      .title =
          "Modeling of the rolling and sliding contact between two asperities. Part II: hemispherical sliding contact",
      .container = "Proceedings of IJTC2006, STLE/ASME International Joint Tribology Conference, San Antonio, Texas",
      .note = "See also Journal of Tribology 129 (2007), 235-245"};
}

Reference chaboche_1986()
{
  return {.key = "chaboche1986",
          .authors = {"Chaboche, J. L."},
          .year = 1986,
          .title = "Time-independent constitutive theories for cyclic plasticity",
          .container = "International Journal of Plasticity",
          .volume = "2",
          .number = "2",
          .pages = "149-188",
          .doi = "10.1016/0749-6419(86)90010-0"};
}

Reference chiu_1978()
{
  return {.key = "chiu1978",
          .authors = {"Chiu, Y. P."},
          .year = 1978,
          .title = "On the stress field and surface deformation in a half space with a cuboidal zone in which initial "
                   "strains are uniform",
          .container = "Journal of Applied Mechanics",
          .volume = "45",
          .number = "2",
          .pages = "302-306",
          .doi = "10.1115/1.3424292"};
}

Reference green_2005()
{
  return {.key = "green2005",
          .authors = {"Green, I."},
          .year = 2005,
          .title = "Poisson ratio effects and critical values in spherical and cylindrical Hertzian contacts",
          .container = "International Journal of Applied Mechanics and Engineering",
          .volume = "10",
          .number = "3",
          .pages = "451-462"};
}

Reference hertz_1882()
{
  return {.key = "hertz1882",
          .authors = {"Hertz, H."},
          .year = 1882,
          .title = "Ueber die Berührung fester elastischer Körper",
          .container = "Journal für die reine und angewandte Mathematik",
          .volume = "92",
          .pages = "156-171",
          .doi = "10.1515/crll.1882.92.156"};
}

Reference hollomon_1945()
{
  return {.key = "hollomon1945",
          .authors = {"Hollomon, J. H."},
          .year = 1945,
          .title = "Tensile deformation",
          .container = "Transactions of the AIME",
          .volume = "162",
          .pages = "268-290"};
}

Reference jacq_2002()
{
  return {.key = "jacq2002",
          .authors = {"Jacq, C.", "Nélias, D.", "Lormand, G.", "Girodin, D."},
          .year = 2002,
          .title = "Development of a three-dimensional semi-analytical elastic-plastic contact code",
          .container = "Journal of Tribology",
          .volume = "124",
          .number = "4",
          .pages = "653-667",
          .doi = "10.1115/1.1467920"};
}

Reference johnson_1985()
{
  return {.key = "johnson1985",
          .kind = Kind::book,
          .authors = {"Johnson, K. L."},
          .year = 1985,
          .title = "Contact Mechanics",
          .publisher = "Cambridge University Press",
          .doi = "10.1017/CBO9781139171731"};
}

Reference liu_2000()
{
  return {.key = "liu2000",
          .authors = {"Liu, S.", "Wang, Q.", "Liu, G."},
          .year = 2000,
          .title = "A versatile method of discrete convolution and FFT (DC-FFT) for contact analyses",
          .container = "Wear",
          .volume = "243",
          .pages = "101-111",
          .doi = "10.1016/S0043-1648(00)00427-0"};
}

Reference love_1929()
{
  return {.key = "love1929",
          .authors = {"Love, A. E. H."},
          .year = 1929,
          .title = "The stress produced in a semi-infinite solid by pressure on part of the boundary",
          .container = "Philosophical Transactions of the Royal Society of London A",
          .volume = "228",
          .pages = "377-420",
          .doi = "10.1098/rsta.1929.0009"};
}

Reference ludwik_1909()
{
  return {.key = "ludwik1909",
          .kind = Kind::book,
          .authors = {"Ludwik, P."},
          .year = 1909,
          .title = "Elemente der technologischen Mechanik",
          .publisher = "Springer, Berlin"};
}

Reference ortiz_1985()
{
  return {.key = "ortiz1985",
          .authors = {"Ortiz, M.", "Popov, E. P."},
          .year = 1985,
          .title = "Accuracy and stability of integration algorithms for elastoplastic constitutive relations",
          .container = "International Journal for Numerical Methods in Engineering",
          .volume = "21",
          .number = "9",
          .pages = "1561-1576",
          .doi = "10.1002/nme.1620210902"};
}

Reference polonsky_1999()
{
  return {.key = "polonsky1999",
          .authors = {"Polonsky, I. A.", "Keer, L. M."},
          .year = 1999,
          .title = "A numerical method for solving rough contact problems based on the multi-level multi-summation and "
                   "conjugate gradient techniques",
          .container = "Wear",
          .volume = "231",
          .number = "2",
          .pages = "206-219",
          .doi = "10.1016/S0043-1648(99)00113-1"};
}

Reference prager_1956()
{
  return {.key = "prager1956",
          .authors = {"Prager, W."},
          .year = 1956,
          .title = "A new method of analyzing stresses and strains in work-hardening plastic solids",
          .container = "Journal of Applied Mechanics",
          .volume = "23",
          .pages = "493-496",
          .doi = "10.1115/1.4011389"};
}

Reference simo_1998()
{
  return {.key = "simo1998",
          .kind = Kind::book,
          .authors = {"Simo, J. C.", "Hughes, T. J. R."},
          .year = 1998,
          .title = "Computational Inelasticity",
          .publisher = "Springer, New York",
          .doi = "10.1007/b98904"};
}

Reference sneddon_1965()
{
  return {.key = "sneddon1965",
          .authors = {"Sneddon, I. N."},
          .year = 1965,
          .title = "The relation between load and penetration in the axisymmetric Boussinesq problem for a punch of "
                   "arbitrary profile",
          .container = "International Journal of Engineering Science",
          .volume = "3",
          .number = "1",
          .pages = "47-57"};
}

Reference swift_1952()
{
  return {.key = "swift1952",
          .authors = {"Swift, H. W."},
          .year = 1952,
          .title = "Plastic instability under plane stress",
          .container = "Journal of the Mechanics and Physics of Solids",
          .volume = "1",
          .number = "1",
          .pages = "1-18",
          .doi = "10.1016/0022-5096(52)90002-1"};
}

Reference ville_1999()
{
  return {.key = "ville1999",
          .authors = {"Ville, F.", "Nélias, D."},
          .year = 1999,
          .title = "An experimental study on the concentration and shape of dents caused by spherical metallic "
                   "particles in EHL contacts",
          .container = "Tribology Transactions",
          .volume = "42",
          .number = "1",
          .pages = "231-240"};
}

Reference voce_1948()
{
  return {.key = "voce1948",
          .authors = {"Voce, E."},
          .year = 1948,
          .title = "The relationship between stress and strain for homogeneous deformation",
          .container = "Journal of the Institute of Metals",
          .volume = "74",
          .pages = "537-562"};
}

Reference walker_2011()
{
  return {.key = "walker2011",
          .authors = {"Walker, H. F.", "Ni, P."},
          .year = 2011,
          .title = "Anderson acceleration for fixed-point iterations",
          .container = "SIAM Journal on Numerical Analysis",
          .volume = "49",
          .number = "4",
          .pages = "1715-1735",
          .doi = "10.1137/10078356X"};
}

Reference wilkins_1964()
{
  return {.key = "wilkins1964",
          .kind = Kind::chapter,
          .authors = {"Wilkins, M. L."},
          .year = 1964,
          .title = "Calculation of elastic-plastic flow",
          .container = "Methods in Computational Physics",
          .volume = "3",
          .pages = "211-263",
          .publisher = "Academic Press, New York"};
}

} // namespace brinell::io::references
