/**
 * The {@code .jen} file: text to {@link lightning.scene.Scene} and back without losing a bit, a
 * comment or a place. The grammar is in {@code docs/jen-format.md}.
 *
 * <pre>{@code
 * JenDocument document = JenReader.read(Path.of("scenes/bird.jen"));
 * Scene dimmer = PropertyEdit.apply(document.scene(), "key.intensity=0.4");
 * document.with(dimmer).save(Path.of("scenes/bird.jen"));
 * }</pre>
 *
 * <p>The way of a file: {@code SourceText} (bytes to characters) → {@code Lexer} → {@code Parser}
 * (blocks with places) → {@code SceneBuilder}. What a block may hold stands in one table,
 * {@code BlockTypes}, which the parser, the writer, the patch and {@link lightning.format.jen.PropertyEdit} share.
 */
package lightning.format.jen;
