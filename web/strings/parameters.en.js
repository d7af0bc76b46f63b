/** What the diagrams of the parameters say of a cam, in English. */
/** @type {Record<string, import("./index.js").Phrase>} */
export const parametersEn = {
  "parameters.pressure_angle":
    "φ is the angle between the push of the cam, along the contact normal, and the way the follower moves. Beyond the limit the push goes into the guide instead of the lift.",
  "parameters.pressure_angle.within":
    "In this cam φ goes from {min} (at {minAt}) to {max} (at {maxAt}). Where it is steepest, {steepest} at {at}, it keeps within ±{limit}.",
  "parameters.pressure_angle.beyond":
    "In this cam φ reaches {steepest} at {at}, beyond ±{limit}: the follower may jam there. A larger base circle makes the slope gentler.",
  "parameters.pressure_angle.flat":
    "A flat face always pushes at right angles to itself: φ is {value} all around, whatever the profile; the limit is {limit}.",
  "parameters.rho":
    "ρ is the radius of the circle that fits the profile best at the contact: positive where the cam is convex. At ρ = 0 it has a cusp.",
  "parameters.rho.convex":
    "This profile is convex all around: sharpest at {at}, with ρ = {value}, and flattest at {maxAt}, with ρ = {max}.",
  "parameters.rho.both":
    "This profile is sharpest at {at}, with ρ = {value}. It is hollow as well, tightest at {hollowAt} with a radius of {hollow}, into which a radius of {roller} must fit; it passes from one to the other at {inflections}.",
  "parameters.rho.hollow":
    "This profile is convex nowhere; its tightest hollow, at {hollowAt}, has a radius of {hollow}.",
  "parameters.rho.undercut":
    "At {at} the pitch curve bends more tightly than the roller of {roller}: ρ comes out as {value}, the profile would cross itself, and the motion is lost.",
  "parameters.rho.flat":
    "A flat face reaches into no hollow, so ρ must stay above zero: here the least is {value}, at {at}.",
  "parameters.rho.flat.undercut":
    "A flat face reaches into no hollow, so ρ must stay above zero: here it falls to {value} at {at}. A larger base circle raises it all around.",
  "parameters.contact":
    "q is where the cam touches the face, measured from the follower's axis, + to the right. The dashed lines are the ends of the face.",
  "parameters.contact.swing":
    "q is where the cam touches the face, measured along it from the foot of the perpendicular from the pivot. The dashed lines are the ends of the part in use.",
  "parameters.contact.walk":
    "In this cam the contact walks from {min} (at {minAt}) to {max} (at {maxAt}): q is v itself, so a faster motion needs a longer face.",
  "parameters.contact.walk.inclined": "In this cam the contact walks from {min} (at {minAt}) to {max} (at {maxAt}).",
  "parameters.contact.walk.swing":
    "In this cam the contact walks from {min} (at {minAt}) to {max} (at {maxAt}) from the pivot's foot; it must never come to zero.",
  "parameters.margin": "Margin at each end",
  "parameters.margin.negative": "A margin is not negative.",
  "parameters.face": "The face is at least {least} long: {left} to the left of the axis and {right} to the right.",
  "parameters.face.swing": "The face is at least {least} long from the pivot's foot; it works from {near} to {far}.",
};
