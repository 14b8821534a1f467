/**
 * The {@code .jen} scene format: conversion between text and {@link lightning.scene.Scene} that preserves every bit,
 * comment and position. The grammar is in {@code docs/jen-format.md}.
 *
 * <pre>{@code
 * JenDocument document = JenReader.read(Path.of("scenes/bird.jen"));
 * Scene dimmer = PropertyEdit.apply(document.scene(), "key.intensity=0.4");
 * document.withScene(dimmer).save(Path.of("scenes/bird.jen"));
 * }</pre>
 *
 * <p>A file passes through {@code SourceText} (bytes to characters), {@code Lexer}, {@code Parser} (blocks with positions)
 * and {@code SceneBuilder}. The table {@code BlockTypes} defines the content of blocks for the parser, the writer, the patch
 * and {@link lightning.format.jen.PropertyEdit}.
 */
@NullMarked
package lightning.format.jen;

import org.jspecify.annotations.NullMarked;
