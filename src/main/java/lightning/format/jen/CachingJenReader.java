package lightning.format.jen;

import java.nio.file.Path;
import lightning.scene.Stage;

/** Reader for texts in one folder that caches the files they reference. Not thread-safe. */
public final class CachingJenReader {
    private final AssetFolders assets;

    public CachingJenReader(Path folder) {
        assets = AssetFolders.of(folder);
    }

    /**
     * Reads a scene from a text.
     *
     * @param name name of the text in problems
     * @throws JenException if the text has problems; contains all of them
     */
    public JenDocument read(String text, String name) throws JenException {
        var problems = new ProblemList();
        var source = new SourceText(name, text);
        source.checkSurrogates(problems);
        return JenReader.read(source, assets, Stage.EMPTY, problems);
    }
}
