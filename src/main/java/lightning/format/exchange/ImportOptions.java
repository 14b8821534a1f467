package lightning.format.exchange;

import io.soabase.recordbuilder.core.RecordBuilder;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import lightning.base.text.RefusalException;
import lightning.format.exchange.assembly.LightUnits;
import lightning.format.usd.StageChoice;
import lightning.format.usd.UsdSubdivision;

/**
 * Choices for an import.
 *
 * @param units    units of a glTF file's lights; empty for the default of the program that wrote it ({@link LightUnits#writtenBy})
 * @param levels   refinements of a stage's subdivision surfaces, from 0 to {@link SceneImporter#MAX_LEVELS}
 * @param variants variant of a glTF file's materials, at most one; or choices of a stage's variants, such as {@code look=red}
 * @param camera   name of the scene's camera in a glTF file or a stage; empty for the file's own choice
 * @param frame    time code of the only frame of a stage, −{@link #MAX_FRAME} … {@link #MAX_FRAME}; empty for its animation
 */
@RecordBuilder
public record ImportOptions(Optional<LightUnits> units, int levels, List<String> variants, String camera, OptionalDouble frame)
        implements ImportOptionsBuilder.With {
    public static final ImportOptions DEFAULT =
            new ImportOptions(Optional.empty(), UsdSubdivision.DEFAULT_LEVELS, List.of(), "", OptionalDouble.empty());
    /** Largest time code: beyond it, a number of single precision has no frames. */
    public static final double MAX_FRAME = 1e8;

    public ImportOptions {
        variants = List.copyOf(variants);
        if (frame.isPresent() && !(Math.abs(frame.getAsDouble()) <= MAX_FRAME)) {
            throw new RefusalException("a frame must be from -100000000 to 100000000, was " + frame.getAsDouble());
        }
    }

    /** Returns what is read of a stage. */
    StageChoice stage() {
        return new StageChoice(camera, frame, variants);
    }
}
