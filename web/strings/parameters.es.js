/** Lo que los diagramas de los parámetros dicen de una leva, en español. */
/** @type {Record<string, import("./index.js").Phrase>} */
export const parametersEs = {
  "parameters.pressure_angle":
    "φ es el ángulo entre el empuje de la leva, según la normal de contacto, y la dirección en que se mueve el seguidor. Más allá del límite el empuje se va contra la guía en vez de elevar.",
  "parameters.pressure_angle.within":
    "En esta leva φ va de {min} (en {minAt}) a {max} (en {maxAt}). Donde es mayor, {steepest} en {at}, no sale de ±{limit}.",
  "parameters.pressure_angle.beyond":
    "En esta leva φ llega a {steepest} en {at}, más allá de ±{limit}: allí el seguidor puede atascarse. Un radio base mayor suaviza la pendiente.",
  "parameters.pressure_angle.flat":
    "Una cara plana empuja siempre perpendicularmente a sí misma: φ vale {value} en toda la vuelta, sea cual sea el perfil; el límite es {limit}.",
  "parameters.rho":
    "ρ es el radio de la circunferencia que mejor se ajusta al perfil en el contacto: positivo donde la leva es convexa. Con ρ = 0 hay una cúspide.",
  "parameters.rho.convex":
    "Este perfil es convexo en toda la vuelta: lo más agudo está en {at}, con ρ = {value}, y lo más plano en {maxAt}, con ρ = {max}.",
  "parameters.rho.both":
    "Lo más agudo de este perfil está en {at}, con ρ = {value}. También tiene zonas cóncavas, la más cerrada en {hollowAt}, con un radio de {hollow} en el que debe caber uno de {roller}; pasa de unas a otras en {inflections}.",
  "parameters.rho.hollow":
    "Este perfil no es convexo en ningún punto; su concavidad más cerrada, en {hollowAt}, tiene un radio de {hollow}.",
  "parameters.rho.undercut":
    "En {at} la curva de paso se cierra más que el rodillo, de {roller}: ρ sale {value}, el perfil se cortaría a sí mismo (rebaje) y el movimiento se pierde.",
  "parameters.rho.flat":
    "Una cara plana no entra en ninguna concavidad, así que ρ ha de ser siempre mayor que cero: aquí el menor es {value}, en {at}.",
  "parameters.rho.flat.undercut":
    "Una cara plana no entra en ninguna concavidad, así que ρ ha de ser siempre mayor que cero: aquí baja a {value} en {at}. Un radio base mayor lo sube en toda la vuelta.",
  "parameters.contact":
    "q es el lugar de la cara que toca la leva, medido desde el eje del seguidor, + a la derecha. Las líneas de trazos son los extremos de la cara.",
  "parameters.contact.swing":
    "q es el lugar de la cara que toca la leva, medido sobre ella desde el pie de la perpendicular trazada desde la articulación. Las líneas de trazos son los extremos de la parte que se usa.",
  "parameters.contact.walk":
    "En esta leva el contacto recorre la cara de {min} (en {minAt}) a {max} (en {maxAt}): q es la propia v, así que un movimiento más rápido pide una cara más larga.",
  "parameters.contact.walk.inclined": "En esta leva el contacto recorre la cara de {min} (en {minAt}) a {max} (en {maxAt}).",
  "parameters.contact.walk.swing":
    "En esta leva el contacto recorre la cara de {min} (en {minAt}) a {max} (en {maxAt}) desde ese pie; nunca debe llegar a cero.",
  "parameters.margin": "Margen en cada extremo",
  "parameters.margin.negative": "Un margen no es negativo.",
  "parameters.face": "La cara mide al menos {least}: {left} a la izquierda del eje y {right} a la derecha.",
  "parameters.face.swing": "La cara mide al menos {least} desde ese pie; trabaja de {near} a {far}.",
};
