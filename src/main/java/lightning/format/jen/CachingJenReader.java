package lightning.format.jen;

import java.io.IOException;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import lightning.base.file.FileState;
import lightning.format.jen.asset.AssetFolders;
import lightning.scene.Stage;

/** Reader for texts in one folder that caches the files they reference. Not thread-safe. */
public final class CachingJenReader {
    private final Path folder;
    private AssetFolders assets;
    /** Size and time of each cached file after the last text with provided meshes. */
    private Map<Path, FileState> states = Map.of();

    public CachingJenReader(Path folder) {
        this.folder = folder;
        assets = AssetFolders.of(folder);
    }

    /** Returns the folder that files are resolved against. */
    public Path folder() {
        return folder;
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

    /**
     * Reads a scene from a text, with meshes that are decoded already. Reads a cached file again if its size or time has changed.
     *
     * @param stage shapes with the meshes of their files and parts
     * @throws JenException if the text has problems; contains all of them
     */
    public JenDocument read(String text, String name, Stage stage) throws JenException {
        if (!states.equals(states())) {
            AssetFolders fresh = AssetFolders.of(folder);
            fresh.meshes().provideAs(assets.meshes());
            assets = fresh;
        }
        assets.meshes().provide(stage);
        JenDocument document = read(text, name);
        states = states();
        return document;
    }

    /** Returns size and time of each cached file. */
    private Map<Path, FileState> states() {
        Map<Path, FileState> result = new HashMap<>();
        for (Path file : assets.files()) {
            try {
                result.put(file, FileState.readMetadata(file));
            } catch (IOException e) {
                result.put(file, FileState.MISSING);
            }
        }
        return result;
    }
}
