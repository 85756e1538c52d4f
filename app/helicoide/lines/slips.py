"""The kinds of slip, and what a student reads: what stands there, what it would mean, and what to look at."""

from __future__ import annotations

from typing import Literal

from helicoide.lines.exercise import LineKind
from helicoide.text import Text

SlipName = Literal[
    "blade order", "passive", "order", "difference", "argument order", "orientation", "axis", "join or meet",
    "sine or cosine", "half", "half too much", "opposite", "sense", "axis sign", "sign", "moment", "inverse",
    "conjugate", "conjugate too many", "blade", "name", "unit", "operator", "power", "function", "surplus term",
    "surplus factor", "missing term", "missing factor", "missing argument", "missing function", "unfinished", "part",
    "rounded", "coefficient", "kind", "line",
]  # fmt: skip

SLIPS: dict[SlipName, Text] = {
    "blade order": Text(
        en="“{part}” has its vectors in the other order: exchanging two of them changes the sign, e1e3 = −e3e1. "
        "Which order does this turn have: from which axis to which?",
        pt_BR="“{part}” traz os vetores na outra ordem: trocar dois deles muda o sinal, e1e3 = −e3e1. "
        "De que eixo para que eixo vai este giro?",
    ),
    "passive": Text(
        en="With “{part}” in this place the coordinates change while the object stays (passive). Here the object "
        "itself moves (active): which side has the conjugate?",
        pt_BR="Com “{part}” neste lugar, mudam as coordenadas e o objeto fica parado (passivo). Aqui é o próprio "
        "objeto que se move (ativo): de que lado fica o conjugado?",
    ),
    "order": Text(
        en="“{part}”: the factors are right, but their order is not. These products do not commute. "
        "Read yours from the right: what comes first?",
        pt_BR="“{part}”: os fatores estão certos, a ordem não. Estes produtos não comutam. "
        "Leia o seu da direita para a esquerda: o que vem primeiro?",
    ),
    "difference": Text(
        en="“{part}” is the difference taken the other way round. From which of the two does it lead to the other?",
        pt_BR="“{part}” é a diferença no sentido contrário. Ela leva de qual dos dois ao outro?",
    ),
    "argument order": Text(
        en="“{part}” has the right arguments in another order; here the order matters. What does each place stand for?",
        pt_BR="“{part}” tem os argumentos certos em outra ordem, e aqui a ordem importa. O que significa cada posição?",
    ),
    "orientation": Text(
        en="“{part}”: a join or meet has an orientation, and this order gives the opposite one. "
        "From which to which does it run?",
        pt_BR="“{part}”: join e meet têm orientação, e nesta ordem ela sai oposta. De qual para qual ele vai?",
    ),
    "axis": Text(
        en="“{part}” belongs to another axis. Which axis is meant here, x, y or z?",
        pt_BR="“{part}” é de outro eixo. De que eixo se trata aqui: x, y ou z?",
    ),
    "join or meet": Text(
        en="“{part}”: a join is what its elements span together, a meet is what they have in common. "
        "Which of the two is asked for?",
        pt_BR="“{part}”: join é o que os elementos geram juntos, meet é o que eles têm em comum. "
        "Qual dos dois se pede?",
    ),
    "sine or cosine": Text(
        en="“{part}”: sine and cosine are exchanged. What should remain of it when the angle is 0?",
        pt_BR="“{part}”: seno e cosseno estão trocados. O que deve sobrar quando o ângulo é 0?",
    ),
    "half": Text(
        en="“{part}” stands there whole, where half of it is needed. Where does this formula have its ½: at an angle, "
        "at a mean of two?",
        pt_BR="“{part}” aparece inteiro, onde se precisa da metade. Onde esta fórmula tem o seu ½: em um ângulo, "
        "em uma média de dois?",
    ),
    "half too much": Text(
        en="“{part}” is half of what is needed. Is the ½ already inside the function, or counted twice?",
        pt_BR="“{part}” é a metade do que se precisa. Será que o ½ já está dentro da função, "
        "ou foi contado duas vezes?",
    ),
    "opposite": Text(
        en="“{part}” is exactly the negative of what is expected. Which sign does the first term have?",
        pt_BR="“{part}” é exatamente o oposto do que se espera. Que sinal tem o primeiro termo?",
    ),
    "sense": Text(
        en="“{part}” turns in the opposite sense. By the right-hand rule, which way is positive?",
        pt_BR="“{part}” gira no sentido contrário. Pela regra da mão direita, qual é o sentido positivo?",
    ),
    "axis sign": Text(
        en="“{part}” makes the axis point the other way, so that positive angles turn backwards. Where does it point?",
        pt_BR="“{part}” faz o eixo apontar para o outro lado, e o ângulo positivo gira ao contrário. "
        "Para onde ele aponta?",
    ),
    "sign": Text(
        en="“{part}” has the wrong sign; everything else fits. Where does this sign come from?",
        pt_BR="“{part}” está com o sinal trocado; o resto confere. De onde vem este sinal?",
    ),
    "moment": Text(
        en="“{part}”: the moment has the opposite sign. It is r × v: the point of the line first, then its direction.",
        pt_BR="“{part}”: o momento está com o sinal oposto. Ele é r × v: primeiro o ponto da reta, depois a direção.",
    ),
    "inverse": Text(
        en="“{part}” is the inverse of what is expected: it leads back. From which frame to which should it lead?",
        pt_BR="“{part}” é o inverso do que se espera: faz o caminho de volta. De que sistema para qual ele deve levar?",
    ),
    "conjugate": Text(
        en="“{part}” stands there as it is; here its conjugate belongs. What has to cancel?",
        pt_BR="“{part}” aparece como está; aqui vai o seu conjugado. O que precisa se cancelar?",
    ),
    "conjugate too many": Text(
        en="“{part}” is conjugated, which undoes the motion. Is it meant to be undone here?",
        pt_BR="“{part}” está conjugado, o que desfaz o movimento. É para desfazê-lo aqui?",
    ),
    "blade": Text(
        en="“{part}” is another blade. What is multiplied here: a direction, a turn or a shift? Look at its factors.",
        pt_BR="“{part}” é outra lâmina. O que se multiplica aqui: direção, giro ou deslocamento? Olhe os seus fatores.",
    ),
    "name": Text(
        en="“{part}” is of the right kind, but another one belongs here. What do its letter and its number stand for?",
        pt_BR="“{part}” é do tipo certo, mas aqui vai outro. O que indicam a letra e o número dele?",
    ),
    "unit": Text(
        en="“{part}” has another unit. Angles are in radians here, lengths in metres; deg(x) converts from degrees.",
        pt_BR="“{part}” está em outra unidade. Aqui os ângulos são em radianos e os comprimentos em metros; "
        "deg(x) converte de graus.",
    ),
    "operator": Text(
        en="“{part}”: the two sides fit, but not the operator between them. What should the first do to the second?",
        pt_BR="“{part}”: os dois lados conferem, mas o operador entre eles não. "
        "O que o primeiro deve fazer com o segundo?",
    ),
    "power": Text(
        en="“{part}” has another power than it should. Is the thing itself meant here, its square, or its root?",
        pt_BR="“{part}” está com outra potência. O que vai aqui: ele próprio, o quadrado ou a raiz dele?",
    ),
    "function": Text(
        en="“{part}”: what is inside fits already, without the function around it. What does the function make of it?",
        pt_BR="“{part}”: o que está dentro já confere, sem a função em volta. O que a função faz dele?",
    ),
    "surplus term": Text(
        en="“{part}” is one term too many; without it the line would be right. What would it stand for?",
        pt_BR="“{part}” é um termo a mais; sem ele a linha estaria certa. O que ele representaria?",
    ),
    "surplus factor": Text(
        en="“{part}” is one factor too many; without it the line would be right. Is it counted already?",
        pt_BR="“{part}” é um fator a mais; sem ele a linha estaria certa. Será que ele já foi contado?",
    ),
    "missing term": Text(
        en="“{part}” fits, but a term is missing. What else contributes?",
        pt_BR="“{part}” confere, mas falta um termo. O que mais contribui?",
    ),
    "missing factor": Text(
        en="“{part}” fits, but a factor is missing. What else acts here, and on which side?",
        pt_BR="“{part}” confere, mas falta um fator. O que mais age aqui, e de que lado?",
    ),
    "missing function": Text(
        en="“{part}” is not enough by itself: a function has to be applied to it. What should come out?",
        pt_BR="“{part}” sozinho não basta: falta aplicar uma função a ele. O que deve sair?",
    ),
    "missing argument": Text(
        en="“{part}” fits, but one more belongs into it. What else takes part?",
        pt_BR="“{part}” confere, mas falta mais um elemento nele. O que mais participa?",
    ),
    "unfinished": Text(
        en="“{part}” is right as far as it goes: it is a part of the answer. What remains to be done with it?",
        pt_BR="“{part}” está certo até aqui: é uma parte da resposta. O que falta fazer com isto?",
    ),
    "part": Text(
        en="“{part}” is where your line begins to differ. What does it stand for?",
        pt_BR="É em “{part}” que a sua linha começa a diferir. O que isto representa?",
    ),
    "rounded": Text(
        en="“{part}” is rounded, and nearly right. Write it exactly, such as pi/2 or sqrt(2)/2.",
        pt_BR="“{part}” está arredondado, e quase certo. Escreva o valor exato, como pi/2 ou sqrt(2)/2.",
    ),
    "coefficient": Text(
        en="“{part}” is the first term that does not fit: look at what multiplies {blades}.",
        pt_BR="“{part}” é o primeiro termo que não confere: olhe o que multiplica {blades}.",
    ),
    "kind": Text(
        en="“{part}” is another kind of thing: it is a {kind}, and what is asked for is a {wanted}.",
        pt_BR="“{part}” é outro tipo de coisa: o tipo é “{kind}”, e o que se pede é do tipo “{wanted}”.",
    ),
    "line": Text(
        en="“{part}” does not lead to what is asked for, and no single change would do. Write it in small steps: "
        "what happens first?",
        pt_BR="“{part}” não leva ao que se pede, e nenhuma mudança sozinha resolve. Escreva em passos pequenos: "
        "o que acontece primeiro?",
    ),
}

OF_MOTIONS = Text(
    en="“{part}”: the motors are right, but their order is not. The rightmost acts first, in the frame that those to "
    "its left have moved. Which joint carries which?",
    pt_BR="“{part}”: os motores estão certos, a ordem não. O da direita age primeiro, no sistema que os da esquerda "
    "movem. Que junta carrega qual?",
)
WORLD_OR_TOOL = Text(
    en="“{part}”: what stands on the left is measured in the frame of the world, what stands on the right in that of "
    "the end effector. In which frame is this error asked for?",
    pt_BR="“{part}”: o que está à esquerda é medido no sistema do mundo; o que está à direita, no do efetuador. "
    "Em qual dos dois se pede este erro?",
)
FROM_BOTH_SIDES = Text(
    en="“{part}” stands there whole. A motor acts from both sides, and each side does half of the motion: "
    "is there a ½ to write?",
    pt_BR="“{part}” aparece inteiro. Um motor age pelos dois lados, e cada lado faz metade do movimento: "
    "não falta um ½?",
)
DOUBLE_COVER = Text(
    en="“{part}” is −M where M is asked for. Both are the same motion, the double cover; here the sign counts. "
    "What is its value when nothing moves?",
    pt_BR="“{part}” é −M onde se pede M. Os dois são o mesmo movimento (recobrimento duplo), mas aqui o sinal conta. "
    "Quanto ele vale quando nada se move?",
)
OTHER_SIDE = Text(
    en="“{part}” is the right one with the opposite orientation: the other side of the plane, or the line run "
    "backwards. Which way should it point?",
    pt_BR="“{part}” é o certo com a orientação oposta: o outro lado do plano, ou a reta percorrida ao contrário. "
    "Para onde ele deve apontar?",
)
# What the same slip means in some kinds of exercise.
IN_A_KIND: dict[tuple[LineKind, SlipName], Text] = {
    ("motor", "order"): OF_MOTIONS,
    ("chain", "order"): OF_MOTIONS,
    ("error", "order"): WORLD_OR_TOOL,
    ("motor", "half"): FROM_BOTH_SIDES,
    ("chain", "half"): FROM_BOTH_SIDES,
    ("jacobian", "half"): FROM_BOTH_SIDES,
    ("incidence", "opposite"): OTHER_SIDE,
    ("motor", "opposite"): DOUBLE_COVER,
    ("chain", "opposite"): DOUBLE_COVER,
}


def words_of(slip: SlipName, kind: LineKind) -> Text:
    """What a slip means in a kind of exercise, with the field {part} for what stands there."""
    return IN_A_KIND.get((kind, slip), SLIPS[slip])
