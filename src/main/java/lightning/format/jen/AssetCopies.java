package lightning.format.jen;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.SortedMap;
import lightning.base.file.AtomicFile;
import lightning.base.file.RegularFile;
import lightning.base.text.Messages;
import lightning.base.text.Quote;
import lightning.format.jen.asset.AssetSearchPath;
import lightning.scene.Scene;

/** Copies the files that a scene references to where a copy of the scene finds them. */
public final class AssetCopies {
    private static final String EXPECTED_FILE = "a file that a scene references";

    private AssetCopies() {}

    /**
     * Copies the files that are missing for a scene file in another folder. Replaces no file.
     *
     * @param from folder of the scene file
     * @param to   folder of the copy
     * @throws IOException if a file is missing or cannot be copied, or if a different file has its name
     */
    public static void copy(Scene scene, Path from, Path to) throws IOException {
        for (Map.Entry<String, SortedMap<String, Path>> files : ReferencedFiles.bySubfolder(scene, from).entrySet()) {
            for (Map.Entry<String, Path> file : files.getValue().entrySet()) {
                copy(file.getKey(), file.getValue(), to, files.getKey());
            }
        }
    }

    private static void copy(String name, Path file, Path scene, String subfolder) throws IOException {
        List<Path> folders = new AssetSearchPath(scene, "file", subfolder).folders();
        for (Path folder : folders) {
            Path existing = folder.resolve(name);
            if (Files.exists(existing)) {
                if (RegularFile.haveSameContent(file, existing, EXPECTED_FILE)) {
                    return;
                }
                throw new IOException(Messages.tr("another file {0} is in {1}; choose another folder", Quote.of(name), Quote.path(folder)));
            }
        }
        Path target = (folders.size() > 1 ? folders.getLast() : scene.resolve(subfolder)).resolve(name);
        Files.createDirectories(target.getParent());
        AtomicFile.write(target, out -> {
            try (InputStream in = RegularFile.open(file, EXPECTED_FILE)) {
                in.transferTo(out);
            }
        });
    }
}
