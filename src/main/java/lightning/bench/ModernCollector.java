package lightning.bench;

import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import lightning.bench.result.ColdStart;
import lightning.bench.result.ErrorCurve;
import lightning.bench.result.FirstPassResult;
import lightning.bench.result.ModernEdit;
import lightning.bench.result.ModernPicture;
import lightning.bench.result.ModernSampling;
import lightning.bench.result.ModernScene;
import org.jspecify.annotations.Nullable;

/** Collector of one modern scene's results so far. */
final class ModernCollector {
    private final String scene;
    private final List<String> losses;
    private final Map<ModernSampling, PictureCollector> pictures = new EnumMap<>(ModernSampling.class);
    private final List<ErrorCurve> curves = new ArrayList<>();

    /** Results of one kind of anti-aliasing so far. */
    private static final class PictureCollector {
        private PictureSize editSize = new PictureSize(0, 0);
        private @Nullable FirstPassResult firstPass;
        private List<ModernEdit> edits = List.of();
        private PictureSize coldSize = new PictureSize(0, 0);
        private @Nullable ColdStart cold;
    }

    ModernCollector(String scene, List<String> losses) {
        this.scene = scene;
        this.losses = losses;
    }

    void setEdits(ModernSampling sampling, PictureSize size, FirstPassResult firstPass, List<ModernEdit> edits) {
        PictureCollector picture = picture(sampling);
        picture.editSize = size;
        picture.firstPass = firstPass;
        picture.edits = edits;
    }

    void setCold(ModernSampling sampling, PictureSize size, ColdStart cold) {
        PictureCollector picture = picture(sampling);
        picture.coldSize = size;
        picture.cold = cold;
    }

    void addCurve(ErrorCurve curve) {
        curves.add(curve);
    }

    private PictureCollector picture(ModernSampling sampling) {
        return pictures.computeIfAbsent(sampling, _ -> new PictureCollector());
    }

    ModernScene result() {
        return new ModernScene(scene, pictures.entrySet().stream().map(entry -> result(entry.getKey(), entry.getValue())).toList(), curves,
                losses);
    }

    private static ModernPicture result(ModernSampling sampling, PictureCollector p) {
        return new ModernPicture(sampling, p.editSize.width(), p.editSize.height(), p.firstPass, p.edits, p.coldSize.width(),
                p.coldSize.height(), p.cold);
    }
}
