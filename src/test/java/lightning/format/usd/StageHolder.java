package lightning.format.usd;

import java.nio.file.Path;
import lightning.base.work.Progress;

/** Process that reads a stage until it is killed. */
final class StageHolder {
    private StageHolder() {}

    public static void main(String... args) throws Exception {
        System.out.println("reading");
        UsdStage.read(Path.of(args[0]), StageChoice.DEFAULT, Progress.NONE, _ -> "");
    }
}
