package lightning.format.jen;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import lightning.base.file.ParentFolder;
import lightning.base.file.RegularFile;
import lightning.format.jen.asset.AssetFolders;
import lightning.format.jen.asset.JenLimits;
import lightning.scene.Scene;
import lightning.scene.Stage;
import lightning.scene.shot.Shot;

/** Reader for {@code .jen} files. */
public final class JenReader {
    private JenReader() {}

    /**
     * Reads a scene file and the files it references. Images, profiles and meshes that cannot be used are left out and {@linkplain JenDocument#notes noted}.
     *
     * @throws IOException if the file cannot be read, or is a folder, a pipe or a device; these are not opened, since
     *     reading could block or never end
     * @throws JenException if its content has problems; contains all of them
     */
    public static JenDocument read(Path file) throws IOException, JenException {
        return read(file, ParentFolder.of(file), Stage.EMPTY);
    }

    /**
     * Reads a light rig for a scene: its lights may be linked to that scene's shapes, and its files are resolved against the
     * scene's folder.
     *
     * @param folder folder of the scene
     * @param stage shapes that the lights may be linked to
     * @return the file's content, with defaults for everything else, and its own stage if it has one
     * @throws IOException as {@link #read(Path)}
     * @throws JenException as {@link #read(Path)}, also if a file cannot be used
     */
    public static Scene readLights(Path file, Path folder, Stage stage) throws IOException, JenException {
        return read(file, folder, stage).requireAllFiles().scene();
    }

    private static JenDocument read(Path file, Path folder, Stage stage) throws IOException, JenException {
        var problems = new ProblemList();
        RegularFile.check(file, "a .jen file");
        if (Files.size(file) > JenLimits.FILE_BYTES) {
            throw tooLarge(file, problems);
        }
        byte[] bytes;
        // The file may grow after the size check.
        try (InputStream in = RegularFile.open(file, "a .jen file")) {
            bytes = in.readNBytes(JenLimits.FILE_BYTES + 1);
        }
        if (bytes.length > JenLimits.FILE_BYTES) {
            throw tooLarge(file, problems);
        }
        return read(SourceText.decode(file.toString(), bytes, problems), AssetFolders.of(folder), stage, problems);
    }

    private static JenException tooLarge(Path file, ProblemList problems) {
        problems.add(0, "a scene file may have at most " + JenLimits.FILE_BYTES + " bytes, found more");
        return new JenException(problems.toProblems(new SourceText(file.toString(), "")));
    }

    /**
     * Reads a scene from a text.
     *
     * @param name name of the text in problems
     * @param folder folder that files are resolved against
     * @throws JenException if the text has problems; contains all of them
     */
    public static JenDocument read(String text, String name, Path folder) throws JenException {
        var problems = new ProblemList();
        var source = new SourceText(name, text);
        source.checkSurrogates(problems);
        return read(source, AssetFolders.of(folder), Stage.EMPTY, problems);
    }

    static JenDocument read(SourceText source, AssetFolders files, Stage stage, ProblemList problems) throws JenException {
        TokenList tokens = Lexer.tokens(source.text(), problems);
        if (!Parser.isSceneFile(tokens)) {
            var other = new ProblemList();
            other.add(tokens.start(0), "not a scene file, which begins with 'jen 1'; found " + tokens.describe(0));
            throw new JenException(other.toProblems(source));
        }
        List<Block> blocks = Parser.parseFile(tokens, problems);
        var notes = FileNotes.create();
        Optional<Scene> scene = new SceneBuilder(tokens, problems, notes, files, List.of(), stage).build(blocks);
        if (scene.isEmpty()) {
            throw new JenException(problems.toProblems(source));
        }
        Optional<Shot> shot = new ShotBuilder(tokens, problems, scene.get()).build(blocks);
        if (!problems.isEmpty()) {
            throw new JenException(problems.toProblems(source));
        }
        return new JenDocument(scene.get(), shot, source.text(), notes.toProblems(source), notes.leftOut());
    }
}
