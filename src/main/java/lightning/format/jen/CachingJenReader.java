package lightning.format.jen;

import java.nio.file.Path;
import lightning.scene.Stage;

/** Reads texts as if they were files of one folder, each file that they name once for all of them. Not for two threads at once. */
public final class CachingJenReader {
    private final AssetFolders assets;

    public CachingJenReader(Path folder) {
        assets = AssetFolders.of(folder);
    }

    /**
     * Reads a scene from a text.
     *
     * @param name how problems call the text
     * @throws JenException if anything is wrong; holds all problems
     */
    public JenDocument read(String text, String name) throws JenException {
        var problems = new ProblemList();
        var source = new SourceText(name, text);
        source.checkSurrogates(problems);
        return JenReader.read(source, assets, Stage.EMPTY, problems);
    }
}
