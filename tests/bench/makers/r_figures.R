# SPDX-License-Identifier: Apache-2.0
# Figures of R. Each says what it wrote and where: Rscript r_figures.R FOLDER DPI
# One file a figure, NAME.truth: kind, x, y in percent from left and top, text, parted by tabs. Of arrows the text is a place behind
# the tip, of curves their points, of bars the corner across, behind what they look like.
arguments <- commandArgs(trailingOnly = TRUE)
folder <- arguments[1]
dpi <- as.numeric(arguments[2])
truth <- character()

across <- function(x) 100 * grconvertX(x, "user", "ndc")
down <- function(y) 100 - 100 * grconvertY(y, "user", "ndc")
note <- function(text, x, y, kind = "word")
  truth <<- c(truth, sprintf("%s\t%.3f\t%.3f\t%s", kind, x, y, text))
say <- function(text, x, y, ...) { text(x, y, text, ...); note(text, across(x), down(y)) }
# Of a line of the margin, counted from the edge of the plot.
line_height <- function() par("mai")[1] / par("mar")[1] / par("din")[2] * 100
middle <- function(axis) mean(par("usr")[if (axis == 1) 1:2 else 3:4])
heading <- function(text) { title(main = text); note(text, 50 + 0 * across(middle(1)), down(par("usr")[4]) - 2.2 * line_height()); note(text, 0, 0, "title") }
names_of_axes <- function(x, y) {
  title(xlab = x, ylab = y)
  note(x, across(middle(1)), down(par("usr")[3]) + 3.2 * line_height())
  note(y, across(par("usr")[1]) - 3.2 * line_height() * par("din")[2] / par("din")[1], down(middle(2)))
}
ticks <- function(side, at, labels = at) {
  axis(side, at = at, labels = labels, gap.axis = -1)
  for (i in seq_along(at)) if (side == 1) note(labels[i], across(at[i]), down(par("usr")[3]) + 1.3 * line_height())
    else note(labels[i], across(par("usr")[1]) - 1.3 * line_height() * par("din")[2] / par("din")[1], down(at[i]))
}
curve_of <- function(x, y, look = "line")
  note(paste(look, paste(sprintf("%.3f,%.3f", across(x), down(y)), collapse = " ")), 0, 0, "curve")
ring_of <- function(x, y) curve_of(c(x, x[1]), c(y, y[1]))
bar_of <- function(left, bottom, right, top, look = "bar")
  note(sprintf("%s %.3f,%.3f", look, across(right), down(bottom)), across(left), down(top), "bar")
points_of <- function(x, y) for (i in seq_along(x)) note("", across(x[i]), down(y[i]), "point")
key <- function(place, names, ...) {
  made <- legend(place, legend = names, ...)
  for (i in seq_along(names)) note(names[i], across(made$text$x[i]) + 3, down(made$text$y[i]))
}
empty <- function(x, y, ...) plot(x, y, type = "n", axes = FALSE, xlab = "", ylab = "", ...)

figures <- list(
  line = function() {
    y <- c(3, 4, 8, 12, 17, 20, 22, 21, 17, 12, 7, 4)
    empty(1:12, y); box()
    lines(1:12, y, lwd = 2, col = "blue"); curve_of(1:12, y)
    ticks(1, c(2, 4, 6, 8, 10, 12)); ticks(2, c(5, 10, 15, 20))
    heading("Rainfall in Lisbon"); names_of_axes("Month", "Days of rain")
  },
  scatter = function() {
    x <- runif(30, 150, 190); y <- x * 0.8 - 70 + rnorm(30, 0, 5)
    empty(c(145, 195), c(40, 90)); box(); points(x, y, pch = 19); points_of(x, y)
    ticks(1, c(150, 160, 170, 180, 190)); ticks(2, c(50, 60, 70, 80))
    heading("Size of dogs"); names_of_axes("Length (cm)", "Mass (kg)")
  },
  bars = function() {
    at <- barplot(c(12, 19, 7, 15), axes = FALSE, ylim = c(0, 20), col = "grey60")
    for (i in 1:4) bar_of(at[i] - 0.5, 0, at[i] + 0.5, c(12, 19, 7, 15)[i])
    ticks(1, as.vector(at), c("Oak", "Beech", "Pine", "Birch")); ticks(2, c(0, 5, 10, 15, 20))
    heading("Trees in the park"); names_of_axes("Kind", "Number")
  },
  box = function() {
    groups <- list(rnorm(40, 20, 3), rnorm(40, 25, 4), rnorm(40, 31, 3))
    made <- boxplot(groups, axes = FALSE, ylim = c(10, 42)); box()
    for (i in 1:3) {
      q <- made$stats[, i]
      ring_of(i + c(-0.4, 0.4, 0.4, -0.4), q[c(2, 2, 4, 4)]); curve_of(i + c(-0.4, 0.4), q[c(3, 3)])
      curve_of(c(i, i), q[1:2]); curve_of(c(i, i), q[4:5])
    }
    points_of(made$group, made$out)
    ticks(1, 1:3, c("Low", "Middle", "High")); ticks(2, c(10, 20, 30, 40))
    heading("Growth by dose"); names_of_axes("Dose", "Height in mm")
  },
  histogram = function() {
    made <- hist(rnorm(300, 50, 10), breaks = seq(0, 100, 10), axes = FALSE, main = "", xlab = "", ylab = "", ylim = c(0, 130), col = "white")
    for (i in which(made$counts > 3)) bar_of(made$breaks[i], 0, made$breaks[i + 1], made$counts[i])
    ticks(1, c(20, 40, 60, 80)); ticks(2, c(0, 50, 100))
    heading("Marks of a class"); names_of_axes("Mark", "Pupils")
  },
  legend = function() {
    x <- seq(0, 10, length.out = 80)
    empty(c(0, 10), c(-1.2, 1.6)); box()
    lines(x, sin(x), lwd = 2); lines(x, cos(x), lty = 2, lwd = 2, col = "red"); curve_of(x, sin(x), "solid"); curve_of(x, cos(x), "dashed")
    ticks(1, c(0, 2, 4, 6, 8, 10)); ticks(2, c(-1, 0, 1))
    key("topright", c("sin x", "cos x"), lty = 1:2, col = c("black", "red"), lwd = 2)
    heading("Two functions"); names_of_axes("x", "f(x)")
  },
  pie = function() {
    par(mar = c(1, 1, 4, 1))
    shares <- c(40, 30, 20, 10); names <- c("Water", "Wind", "Sun", "Coal")
    pie(shares, labels = NA, col = c("white", "grey80", "grey60", "grey40"), radius = 0.7)
    from <- cumsum(c(0, shares[-4])) + shares / 2
    turn <- seq(0, 2 * pi, length.out = 90)
    curve_of(0.7 * cos(turn), 0.7 * sin(turn))
    for (a in 2 * pi * c(0, 0.4, 0.7, 0.9)) curve_of(c(0, 0.7 * cos(a)), c(0, 0.7 * sin(a)))
    for (i in 1:4) say(names[i], 0.9 * cos(2 * pi * from[i] / 100), 0.9 * sin(2 * pi * from[i] / 100))
    heading("Where power comes from")
  },
  tree = function() {
    empty(c(0, 10), c(0, 10))
    segments(c(5, 5, 2.5, 2.5), c(9, 9, 6, 6), c(2.5, 7.5, 1, 4), c(7, 7, 3, 3))
    for (i in 1:4) curve_of(c(5, 5, 2.5, 2.5)[i] + c(0, c(-2.5, 2.5, -1.5, 1.5)[i]), c(9, 9, 6, 6)[i] - c(0, c(2, 2, 3, 3)[i]))
    say("Vertebrates", 5, 9.6); say("Fish", 2.5, 6.5); say("Mammals", 7.5, 6.5); say("Sharks", 1, 2.5); say("Trout", 4, 2.5)
    heading("A family tree")
  },
  geometry = function() {
    par(mar = c(1, 1, 4, 1))
    empty(c(0, 10), c(0, 8), asp = 1); polygon(c(1, 9, 3), c(1, 1, 7)); ring_of(c(1, 9, 3), c(1, 1, 7))
    say("A", 0.5, 0.7); say("B", 9.5, 0.7); say("C", 3, 7.6); say("c = 8 cm", 5, 0.4)
    arrows(6, 6.5, 4.2, 5.8, length = 0.15); note(sprintf("%.3f,%.3f", across(6), down(6.5)), across(4.2), down(5.8), "arrow"); say("height", 7.2, 6.7)
    heading("A triangle")
  },
  map = function() {
    par(mar = c(1, 1, 4, 1))
    empty(c(0, 10), c(0, 8)); polygon(c(1, 4, 8, 9, 6, 2), c(2, 1, 2, 5, 7, 6), col = "grey90"); ring_of(c(1, 4, 8, 9, 6, 2), c(2, 1, 2, 5, 7, 6))
    curve_of(c(1.6, 4, 5, 8.2), c(3.6, 3.4, 2.6, 2.4)); points_of(c(3, 6.5), c(4.5, 4))
    points(c(3, 6.5), c(4.5, 4), pch = 19); say("Northport", 3.2, 5.1); say("Milltown", 6.5, 4.6)
    lines(c(1.6, 4, 5, 8.2), c(3.6, 3.4, 2.6, 2.4), col = "blue", lwd = 2); say("River Ash", 5.2, 1.9, font = 3)
    heading("The isle of Ash")
  })

for (name in names(figures)) {
  stem <- file.path(folder, paste0("R-", name))
  for (form in c("svg", "png", "pdf")) {
    set.seed(7)
    truth <- character()
    switch(form, svg = svg(paste0(stem, ".svg"), 6, 5), pdf = pdf(paste0(stem, ".pdf"), 6, 5),
           png = png(paste0(stem, ".png"), 6 * dpi, 5 * dpi, res = dpi, type = "cairo"))
    figures[[name]]()
    invisible(dev.off())
  }
  writeLines(truth, paste0(stem, ".truth"))
}
