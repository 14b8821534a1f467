package lightning.editor.document;

import java.io.IOException;
import java.io.InputStream;
import java.net.URI;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileSystemNotFoundException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import lightning.base.file.AtomicFile;
import lightning.base.file.PrivateFolder;
import lightning.base.file.ProcessIdentity;
import lightning.base.text.Messages;
import lightning.base.text.Quote;
import lightning.format.jen.JenLimits;

/**
 * A folder that keeps unsaved scenes for the case of a crash: for each open document one file, the text of the scene
 * behind a line that names the process and the scene's own file. Nobody but their owner may read them.
 *
 * <p>A file whose process has ended was left behind by a crash.
 */
public final class RecoveryFolder {
    private static final String HEADER = "# Lightning kept this of process ";
    private static final String FILE_SEPARATOR = " for ";
    private static final String EXTENSION = ".kept.jen";
    /** More than the line of any path takes. */
    private static final int MAX_HEADER_BYTES = 1 << 16;

    private final Path folder;
    private final String process;

    /** @param folder made when the first scene is kept */
    public RecoveryFolder(Path folder) {
        this(folder, ProcessIdentity.current().toString());
    }

    RecoveryFolder(Path folder, String process) {
        this.folder = folder;
        this.process = process;
    }

    /**
     * A scene that a crash left unsaved.
     *
     * @param recoveryFile the file in the recovery folder
     * @param file the scene's own file, absolute
     * @param text what that file would hold if it had been saved
     */
    public record RecoverableScene(Path recoveryFile, Path file, String text) {
        /** Forgets it. */
        public void delete() throws IOException {
            Files.deleteIfExists(recoveryFile);
        }
    }

    /**
     * Keeps the text of a scene, in place of what was kept for the same file.
     *
     * @throws IOException if it cannot be written, or has more than {@link JenLimits#FILE_BYTES} bytes; what was kept before is then
     *                     still there
     */
    public void store(Path file, String text) throws IOException {
        PrivateFolder.restrict(folder);
        byte[] header = (HEADER + process + FILE_SEPARATOR + file.toAbsolutePath().toUri() + "\n").getBytes(StandardCharsets.UTF_8);
        byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
        if (bytes.length > JenLimits.FILE_BYTES) {
            throw new IOException(Quote.path(file) + ": "
                    + Messages.tr("expected at most {0} bytes of scene text, found {1}", JenLimits.FILE_BYTES, bytes.length));
        }
        AtomicFile.of(recoveryFile(file)).forOwnerOnly().write((AtomicFile.Content) out -> {
            out.write(header);
            out.write(bytes);
        });
    }

    /** Forgets what this process kept for a file: it was saved, or closed on purpose. */
    public void delete(Path file) throws IOException {
        Files.deleteIfExists(recoveryFile(file));
    }

    /** Takes over what a crash left as this process's own: it is there at every moment, and found by nobody else. */
    public void adopt(RecoverableScene recoverable) throws IOException {
        store(recoverable.file(), recoverable.text());
        recoverable.delete();
    }

    /** What crashed processes left, the latest first. A file that cannot be read is passed over. */
    public List<RecoverableScene> list() throws IOException {
        List<RecoverableScene> scenes = new ArrayList<>();
        if (Files.isDirectory(folder)) {
            try (Stream<Path> files = Files.list(folder)) {
                for (Path recoveryFile : files.filter(RecoveryFolder::isRecoveryFile).toList()) {
                    read(recoveryFile).ifPresent(scenes::add);
                }
            }
        }
        scenes.sort((a, b) -> Long.compare(b.recoveryFile().toFile().lastModified(), a.recoveryFile().toFile().lastModified()));
        return scenes;
    }

    /** Reads the text only where nothing else tells that it is not wanted: it may be large. */
    private Optional<RecoverableScene> read(Path recoveryFile) {
        try {
            String header = readHeader(recoveryFile);
            int separator = header.indexOf(FILE_SEPARATOR, HEADER.length());
            if (!header.startsWith(HEADER) || separator < 0) {
                return Optional.empty();
            }
            Path file = path(header.substring(separator + FILE_SEPARATOR.length()));
            boolean hasNoName = !file.isAbsolute() || file.getFileName() == null;
            if (hasNoName || isAlive(header.substring(HEADER.length(), separator))) {
                return Optional.empty();
            }
            int length = header.getBytes(StandardCharsets.UTF_8).length + 1;
            if (Files.size(recoveryFile) - length > JenLimits.FILE_BYTES) {
                return Optional.empty();
            }
            return Optional.of(new RecoverableScene(recoveryFile, file, Files.readString(recoveryFile).substring(header.length() + 1)));
        } catch (IOException | IllegalArgumentException | FileSystemNotFoundException e) {
            return Optional.empty();
        }
    }

    /** The first line without its end; empty where it has none within {@link #MAX_HEADER_BYTES}. */
    private static String readHeader(Path recoveryFile) throws IOException {
        try (InputStream in = Files.newInputStream(recoveryFile)) {
            String start = new String(in.readNBytes(MAX_HEADER_BYTES), StandardCharsets.UTF_8);
            return start.substring(0, Math.max(0, start.indexOf('\n')));
        }
    }

    private static boolean isRecoveryFile(Path file) {
        return file.getFileName().toString().endsWith(EXTENSION) && Files.isRegularFile(file);
    }

    /** As a URI, which has no line ends; older versions wrote the bare path. */
    private static Path path(String written) {
        return written.startsWith("file:") ? Path.of(URI.create(written)) : Path.of(written);
    }

    private Path recoveryFile(Path file) {
        String path = file.toAbsolutePath().toString();
        return folder.resolve(process + "-" + Integer.toHexString(path.hashCode()) + EXTENSION);
    }

    private static boolean isAlive(String owner) {
        return ProcessIdentity.parse(owner).filter(ProcessIdentity::isRunning).isPresent();
    }
}
