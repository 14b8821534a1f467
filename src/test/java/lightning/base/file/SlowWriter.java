package lightning.base.file;

import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.time.Duration;
import java.time.Instant;
import java.util.stream.Stream;

/** Process that writes a file and pauses in the middle until it reads a line. */
final class SlowWriter {
    private SlowWriter() {}

    public static void main(String... args) throws Exception {
        Path file = Path.of(args[0]);
        AtomicFile.of(file).writeToPath(temporary -> {
            Files.writeString(temporary, "first");
            try (Stream<Path> all = Files.list(file.getParent())) {
                for (Path each : all.toList()) {
                    Files.setLastModifiedTime(each, FileTime.from(Instant.now().minus(Duration.ofHours(2))));
                }
            }
            System.out.println("writing");
            System.in.read();
            Files.writeString(temporary, "whole");
        });
    }
}
