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
import lightning.base.file.PrivateFolder;
import lightning.base.file.ProcessStart;
import lightning.base.file.SafeFile;
import lightning.base.text.Quote;
import lightning.base.text.Texts;
import lightning.format.jen.JenLimits;

/**
 * A folder that keeps unsaved scenes for the case of a crash: for each open document one file, the text of the scene
 * behind a line that names the process and the scene's own file. Nobody but their owner may read them.
 *
 * <p>A file whose process has ended was left behind by a crash.
 */
public final class Recovery {
    private static final String HEAD = "# Lightning kept this of process ";
    private static final String OF = " for ";
    private static final String ENDING = ".kept.jen";
    /** More than the line of any path takes. */
    private static final int HEAD_BYTES = 1 << 16;

    private final Path folder;
    private final String process;

    /** @param folder made when the first scene is kept */
    public Recovery(Path folder) {
        this(folder, ProcessStart.ofThisProcess().toString());
    }

    Recovery(Path folder, String process) {
        this.folder = folder;
        this.process = process;
    }

    /**
     * A scene that a crash left unsaved.
     *
     * @param kept the file in the recovery folder
     * @param file the scene's own file, absolute
     * @param text what that file would hold if it had been saved
     */
    public record Found(Path kept, Path file, String text) {
        /** Forgets it. */
        public void delete() throws IOException {
            Files.deleteIfExists(kept);
        }
    }

    /**
     * Keeps the text of a scene, in place of what was kept for the same file.
     *
     * @throws IOException if it cannot be written, or has more than {@link JenLimits#FILE_BYTES} bytes; what was kept before is then
     *                     still there
     */
    public void keep(Path file, String text) throws IOException {
        PrivateFolder.close(folder);
        byte[] head = (HEAD + process + OF + file.toAbsolutePath().toUri() + "\n").getBytes(StandardCharsets.UTF_8);
        byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
        if (bytes.length > JenLimits.FILE_BYTES) {
            throw new IOException(Quote.path(file) + ": "
                    + Texts.of("the text of a scene may have at most {0} bytes, found {1}", JenLimits.FILE_BYTES, bytes.length));
        }
        SafeFile.at(kept(file)).forOwnerOnly().write((SafeFile.Content) out -> {
            out.write(head);
            out.write(bytes);
        });
    }

    /** Forgets what this process kept for a file: it was saved, or closed on purpose. */
    public void forget(Path file) throws IOException {
        Files.deleteIfExists(kept(file));
    }

    /** Takes over what a crash left as this process's own: it is there at every moment, and found by nobody else. */
    public void adopt(Found found) throws IOException {
        keep(found.file(), found.text());
        found.delete();
    }

    /** What crashed processes left, the latest first. A file that cannot be read is passed over. */
    public List<Found> found() throws IOException {
        List<Found> all = new ArrayList<>();
        if (Files.isDirectory(folder)) {
            try (Stream<Path> files = Files.list(folder)) {
                for (Path kept : files.filter(Recovery::mayBeKept).toList()) {
                    read(kept).ifPresent(all::add);
                }
            }
        }
        all.sort((a, b) -> Long.compare(b.kept().toFile().lastModified(), a.kept().toFile().lastModified()));
        return all;
    }

    /** Reads the text only where nothing else tells that it is not wanted: it may be large. */
    private Optional<Found> read(Path kept) {
        try {
            String head = head(kept);
            int of = head.indexOf(OF, HEAD.length());
            if (!head.startsWith(HEAD) || of < 0) {
                return Optional.empty();
            }
            Path file = path(head.substring(of + OF.length()));
            boolean nameless = !file.isAbsolute() || file.getFileName() == null;
            if (nameless || isAlive(head.substring(HEAD.length(), of))) {
                return Optional.empty();
            }
            int length = head.getBytes(StandardCharsets.UTF_8).length + 1;
            if (Files.size(kept) - length > JenLimits.FILE_BYTES) {
                return Optional.empty();
            }
            return Optional.of(new Found(kept, file, Files.readString(kept).substring(head.length() + 1)));
        } catch (IOException | IllegalArgumentException | FileSystemNotFoundException e) {
            return Optional.empty();
        }
    }

    /** The first line without its end; empty where it has none within {@link #HEAD_BYTES}. */
    private static String head(Path kept) throws IOException {
        try (InputStream in = Files.newInputStream(kept)) {
            String start = new String(in.readNBytes(HEAD_BYTES), StandardCharsets.UTF_8);
            return start.substring(0, Math.max(0, start.indexOf('\n')));
        }
    }

    private static boolean mayBeKept(Path file) {
        return file.getFileName().toString().endsWith(ENDING) && Files.isRegularFile(file);
    }

    /** As a URI, which has no line ends; older versions wrote the bare path. */
    private static Path path(String written) {
        return written.startsWith("file:") ? Path.of(URI.create(written)) : Path.of(written);
    }

    private Path kept(Path file) {
        String path = file.toAbsolutePath().toString();
        return folder.resolve(process + "-" + Integer.toHexString(path.hashCode()) + ENDING);
    }

    private static boolean isAlive(String owner) {
        return ProcessStart.parse(owner).filter(ProcessStart::isRunning).isPresent();
    }
}
