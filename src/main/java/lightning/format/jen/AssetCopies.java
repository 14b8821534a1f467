package lightning.format.jen;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.SortedMap;
import lightning.base.file.AtomicFile;
import lightning.base.file.RegularFile;
import lightning.base.file.UnusableFileException;
import lightning.base.text.Messages;
import lightning.base.text.Quote;
import lightning.base.text.RefusalException;
import lightning.format.jen.asset.AssetSearchPath;
import lightning.format.jen.asset.MeshFolder;
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

    /**
     * Returns the names of the files that a scene names and its folders lack, in alphabetical order.
     *
     * @param folder folder of the scene file
     */
    public static List<String> missing(JenDocument document, Path folder) throws IOException {
        return missingFiles(document, folder).stream().map(LeftOutFile::file).distinct().toList();
    }

    private static List<LeftOutFile> missingFiles(JenDocument document, Path folder) throws IOException {
        List<LeftOutFile> missing = new ArrayList<>();
        for (LeftOutFile file : document.leftOut()) {
            try {
                new AssetSearchPath(folder, "file", file.subfolder()).find(file.file());
            } catch (UnusableFileException e) {
                missing.add(file);
            } catch (RefusalException e) {
                // No file can have this name.
            }
        }
        missing.sort(Comparator.comparing(LeftOutFile::file));
        return missing;
    }

    /**
     * Copies missing files to where a scene finds them: a chosen file, and all others that are next to it.
     *
     * @param name   name of the chosen file in the scene
     * @param folder folder of the scene file
     * @throws IOException if a file cannot be copied
     */
    public static void copyMissing(JenDocument document, String name, Path chosen, Path folder) throws IOException {
        for (LeftOutFile missing : missingFiles(document, folder)) {
            String file = missing.file();
            Path found = file.equals(name) ? chosen : chosen.resolveSibling(file.substring(file.lastIndexOf('/') + 1));
            if (Files.isRegularFile(found)) {
                copy(file, found, folder, missing.subfolder());
                if (missing.subfolder().equals(MeshFolder.NAME)) {
                    for (Map.Entry<String, Path> further : ReferencedFiles.furtherFiles(file, found).entrySet()) {
                        copy(further.getKey(), further.getValue(), folder, missing.subfolder());
                    }
                }
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
