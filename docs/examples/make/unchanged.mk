# make -f unchanged.mk: a change that leaves an object as it is stops there
#
# The stamp tells when the object was last made, the object's own time when it last changed.

MJFORGE = mjforge

objects = $(patsubst specs/%.yaml,out/%.xml,$(wildcard specs/*.yaml))
reports = $(objects:.xml=.txt)

all: $(reports)

out/%.stamp: specs/%.yaml
	$(MJFORGE) generate $< --quiet --seed 7 --force --if-changed -o out/$*.xml -MD -MP -MT $@
	touch $@

# An empty recipe: look at the object's time again.
$(objects): %.xml: %.stamp ;

# What is made from an object.
$(reports): %.txt: %.xml
	$(MJFORGE) inspect $< > $@

.DELETE_ON_ERROR:
.PHONY: all
.SECONDARY:

-include $(objects:.xml=.d)
