package lightning.format.jen;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import lightning.base.text.RefusalException;
import lightning.format.jen.asset.AssetSource;
import lightning.format.jen.asset.NameSuggestion;
import lightning.scene.Scene;
import lightning.scene.shot.Shot;
import lightning.scene.shot.Track;
import lightning.scene.shot.TrackTarget;

/** Builder of the shot from its parsed block; reports conflicts with the scene. */
record ShotBuilder(TokenList tokens, ProblemList problems, Scene scene) {
    /** Returns the shot, or empty if there is none or it has problems. */
    Optional<Shot> build(List<Block> blocks) {
        Block block = blocks.stream().filter(b -> b.type == BlockTypes.SHOT).findFirst().orElse(null);
        if (block == null) {
            return Optional.empty();
        }
        List<Track> tracks = new ArrayList<>();
        Map<TrackTarget, Block> blocksByTarget = new HashMap<>();
        for (Block child : block.children) {
            TrackTarget target = target(child);
            if (!exists(child)) {
                problem(child, "there is no " + child.title() + " in the scene" + NameSuggestion.hint(child.name, scene.lights().stream()
                        .map(l -> l.name()).filter(_ -> child.type == BlockTypes.LIGHT).toList()));
            } else if (blocksByTarget.put(target, child) != null) {
                problem(child, child.title() + " must have its keys in one block, found another");
            } else {
                child.keys.stream().filter(k -> !k.keys().isEmpty()).forEach(k -> buildTrack(child, target, k).ifPresent(tracks::add));
            }
        }
        try {
            Shot shot =
                    BlockTypes.SHOT.builder().build("", new PropertyValues(block::value, AssetSource.NONE), List.of()).withTracks(tracks);
            return problems.isEmpty() ? Optional.of(shot) : Optional.empty();
        } catch (RefusalException e) {
            problem(block, "shot: " + e.getMessage());
            return Optional.empty();
        }
    }

    private Optional<Track> buildTrack(Block child, TrackTarget target, Block.PropertyKeys keys) {
        try {
            Track track = new Track(target, keys.property().name(), keys.keys());
            track.check(scene);
            return Optional.of(track);
        } catch (RefusalException e) {
            problems.add(tokens.start(keys.nameToken()), child.title() + ": " + e.getMessage());
            return Optional.empty();
        }
    }

    static TrackTarget target(Block child) {
        return child.type == BlockTypes.CAMERA ? TrackTarget.CAMERA : child.type == BlockTypes.LIGHT ? TrackTarget.light(child.name)
                : child.type == BlockTypes.LIGHT_GROUP ? TrackTarget.bank(child.name)
                : child.type == BlockTypes.DOME ? TrackTarget.dome(child.name) : TrackTarget.node(child.name);
    }

    private boolean exists(Block child) {
        TrackTarget target = target(child);
        return target.existsIn(scene) && ShotWriter.type(scene, target) == child.type;
    }

    private void problem(Block block, String message) {
        problems.add(tokens.start(block.problemToken()), message);
    }
}
