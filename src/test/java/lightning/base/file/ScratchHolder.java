package lightning.base.file;

import java.nio.file.Path;

/** Process that holds two scratch folders in one place, and files outside, until it is killed. */
final class ScratchHolder {
    private ScratchHolder() {}

    public static void main(String... args) throws Exception {
        try (ScratchFolder scratch = ScratchFolder.createIn(Path.of(args[0])); ScratchFolder _ = ScratchFolder.createIn(Path.of(args[0]))) {
            scratch.write(scratch.file("rows"), _ -> {});
            for (int i = 1; i < args.length; i++) {
                SharedMemoryFile.create(Path.of(args[i]), 100);
                scratch.addOutside(Path.of(args[i]));
            }
            System.out.println("made");
            Thread.sleep(600_000);
        }
    }
}
